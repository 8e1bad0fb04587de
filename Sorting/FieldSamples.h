/**
 * Places where something of the original is known, each kept by the cell that it is nearest to.
 */
#ifndef FieldSamples_h
#define FieldSamples_h

#include <array>
#include <cstddef>
#include <vector>

class FieldSamples
{
public:
  explicit FieldSamples(int cells)
    : First(static_cast<std::size_t>(cells), -1)
  {
  }

  int Add(const double x[3], double value)
  {
    this->Samples.push_back({ { x[0], x[1], x[2] }, value });
    this->NextOf.push_back(-1);
    return static_cast<int>(this->Samples.size()) - 1;
  }
  /** Of a sample that is nowhere yet. */
  void RemoveLast()
  {
    this->Samples.pop_back();
    this->NextOf.pop_back();
  }
  void Put(int sample, int cell)
  {
    this->NextOf[sample] = this->First[cell];
    this->First[cell] = sample;
  }
  /** The sample after `before`. */
  void MoveToFront(int cell, int before)
  {
    const int sample = this->NextOf[before];
    this->NextOf[before] = this->NextOf[sample];
    this->Put(sample, cell);
  }
  void Clear(int cell) { this->First[cell] = -1; }

  int Begin(int cell) const { return this->First[cell]; }
  int Next(int sample) const { return this->NextOf[sample]; }
  const double* GetPoint(int sample) const { return this->Samples[sample].Position.data(); }
  double GetValue(int sample) const { return this->Samples[sample].Value; }
  int GetNumberOfSamples() const { return static_cast<int>(this->Samples.size()); }

private:
  struct Sample
  {
    std::array<double, 3> Position;
    double Value;
  };

  std::vector<Sample> Samples;
  std::vector<int> NextOf; // by sample
  std::vector<int> First;  // by cell
};

#endif
