#include "HardTetrahedra.h"

#include <array>
#include <cmath>

//------------------------------------------------------------------------------
const char* HardTetrahedra::GetName(int kind)
{
  static const std::array<const char*, NumberOfKinds> names = { "any", "on rows", "on columns", "on pixels",
    "of a pixel", "of a row", "of a column", "slivers", "flat", "large" };
  return names[kind];
}

//------------------------------------------------------------------------------
HardTetrahedra::HardTetrahedra(int kind, int count, unsigned int seed)
  : Generator(seed)
{
  for (int i = 0; i < count; ++i)
  {
    this->AddCell(kind);
  }
}

//------------------------------------------------------------------------------
double HardTetrahedra::Random(double least, double greatest)
{
  return std::uniform_real_distribution<double>(least, greatest)(this->Generator);
}

//------------------------------------------------------------------------------
void HardTetrahedra::AddCell(int kind)
{
  double corners[4][3];
  this->Place(kind, corners);
  this->Snap(kind, corners);
  const double slopes[3] = { this->Random(-0.01, 0.01), this->Random(-0.01, 0.01), this->Random(-0.2, 0.2) };
  const double middle = this->Random(0.2, 0.8);
  for (const auto& corner : corners)
  {
    double scalar = middle;
    for (int k = 0; k < 3; ++k)
    {
      scalar += slopes[k] * (corner[k] - (k < 2 ? corners[0][k] : 0.0));
      this->Corners.push_back(static_cast<float>(corner[k]));
    }
    this->Corners.push_back(static_cast<float>(scalar));
  }
}

//------------------------------------------------------------------------------
void HardTetrahedra::Place(int kind, double (&corners)[4][3])
{
  const double least = kind == Large ? 60.0 : 1.0, greatest = kind == Large ? 2000.0 : 40.0;
  const double whole = least * std::pow(greatest / least, this->Random(0.0, 1.0));
  const double few = this->Random(0.2, 1.2);
  const double size[2] = { kind == Pixel || kind == Column ? few : whole, kind == Pixel || kind == Row ? few : whole };
  const double center[2] = { this->Random(-5.0, 69.0), this->Random(-5.0, 69.0) };
  const double turn = this->Random(0.0, 6.3), thin = std::pow(10.0, this->Random(-2.0, 0.0));
  const double depth = kind == Flat ? std::pow(10.0, this->Random(-6.0, -2.0)) : 1.0;
  const double tilt[2] = { this->Random(-0.01, 0.01), this->Random(-0.01, 0.01) };
  for (auto& corner : corners)
  {
    double at[2] = { size[0] * this->Random(-1.0, 1.0), size[1] * this->Random(-1.0, 1.0) };
    if (kind == Slivers)
    {
      const double along = at[0], across = thin * this->Random(-0.5, 0.5);
      at[0] = std::cos(turn) * along - std::sin(turn) * across;
      at[1] = std::sin(turn) * along + std::cos(turn) * across;
    }
    corner[0] = center[0] + at[0];
    corner[1] = center[1] + at[1];
    corner[2] = depth * this->Random(-0.5, 0.5) + tilt[0] * at[0] + tilt[1] * at[1];
  }
}

//------------------------------------------------------------------------------
void HardTetrahedra::Snap(int kind, double (&corners)[4][3])
{
  const bool isOnColumns = kind == OnColumns || kind == OnPixels, isOnRows = kind == OnRows || kind == OnPixels;
  const int places[3] = { isOnColumns ? 4 : 0, isOnRows ? 4 : 0, 0 };
  for (int k = 0; k < 2; ++k)
  {
    for (int i = 0; i < places[k]; ++i)
    {
      // Some share their row or column with the one before.
      const bool isShared = i > 0 && this->Random(0.0, 1.0) < 0.3;
      corners[i][k] = isShared ? corners[i - 1][k] : std::round(corners[i][k]);
    }
  }
}
