// What the transfer function leaves transparent is cut off cells before anything is queued: few
// fragments are left, and the image is that of a function that is nearly transparent there, of which
// nothing is cut off. From outside, from amid the cells and in parallel projection; for a function of
// few pieces and for one that does not fit a vector.

#include "TestScene.h"
#include "TileArrays.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace
{
constexpr int Size = 130;
constexpr glm::dvec3 Eye(0.9, 1.5, 3.5);
// Too little to see, and enough not to be cut off.
constexpr double Little = 1e-9;

/// Peaks of one width, and the same on a floor.
struct Peaks
{
  const char* Name;
  std::vector<double> Middles;
  double HalfWidth;
  /// Fragments that are left, at most.
  double Share;

  double Opacity(double x, double floor) const
  {
    double most = 0.0;
    for (const double middle : this->Middles)
    {
      most = std::max(most, 2.0 * (1.0 - std::abs(x - middle) / this->HalfWidth));
    }
    // What rounding leaves at a peak's foot would be seen.
    return most > Little ? most : floor;
  }
  std::vector<double> Nodes() const
  {
    std::vector<double> nodes = { 0.0, 1.0 };
    for (const double middle : this->Middles)
    {
      nodes.insert(nodes.end(), { middle - this->HalfWidth, middle, middle + this->HalfWidth });
    }
    return nodes;
  }
};

const std::vector<Peaks>& Functions()
{
  static const std::vector<Peaks> functions = { { "one peak", { 0.5 }, 0.05, 0.4 },
    { "three peaks", { 0.2, 0.5, 0.8 }, 0.02, 0.4 },
    { "eight peaks", { 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8 }, 0.02, 0.9 } };
  return functions;
}

std::vector<float> Draw(TileArrays& arrays, const Peaks& peaks, double floor, long long& fragments)
{
  arrays.SetOpacity(
    peaks.Nodes(), [&](double x) { return peaks.Opacity(x, floor); }, 0.2);
  arrays.Render();
  fragments = arrays.Engine.GetCounts().Fragments;
  return arrays.Engine.GetImage();
}

void Compare(TestChecks& checks, TileArrays& arrays, const char* view)
{
  for (const Peaks& peaks : Functions())
  {
    long long all = 0, left = 0;
    const std::vector<float> whole = Draw(arrays, peaks, Little, all);
    const std::vector<float> cut = Draw(arrays, peaks, 0.0, left);
    const double share = static_cast<double>(left) / static_cast<double>(all);
    const double difference = TileArrays::LargestDifference(whole, cut);
    std::cout << view << ", " << peaks.Name << ": " << 100.0 * share << " % of " << all
              << " fragments, largest difference " << difference << "\n";
    CHECK(*std::max_element(cut.begin(), cut.end()) > 0.05f);
    CHECK_AT_MOST(difference, 1e-5);
    CHECK(share < peaks.Share);
  }
}

void CompareViews(TestChecks& checks, TileArrays& arrays)
{
  arrays.LookFrom(Eye, 35.0, Size, Size);
  Compare(checks, arrays, "outside");
  arrays.LookFrom({ 0.11, 0.05, 0.02 }, 100.0, Size, Size);
  Compare(checks, arrays, "amid the cells");
  arrays.LookFrom(Eye, 35.0, Size, Size);
  arrays.Scene.Camera.ViewToClip = glm::ortho(-1.5, 1.5, -1.5, 1.5, 0.01, 20.0);
  Compare(checks, arrays, "parallel");
}
}

int TestTilesCuts(int, char*[])
{
  TestChecks checks;
  TileArrays arrays(16);
  arrays.SetMesh();
  CompareViews(checks, arrays);
  // Along a ray the scalar is one value: every cut is seen edge-on.
  const glm::dvec3 across = glm::normalize(glm::cross(Eye, glm::dvec3(0.0, 0.0, 1.0)));
  for (std::size_t point = 0; point < arrays.Scalars.size(); ++point)
  {
    const float* x = &arrays.Points[4 * point];
    arrays.Scalars[point] =
      static_cast<float>(0.5 + 0.25 * glm::dot(across, glm::dvec3(x[0], x[1], x[2])));
  }
  arrays.SetMesh();
  Compare(checks, arrays, "edge-on");
  return checks.Result();
}
