#include "TileTransfer.h"

#include "TransferFunction.h"

#include <algorithm>

namespace
{
// Optical depths beyond this leave nothing of the light, and would leave the range of a float.
constexpr double DeepestRay = 1e9;
}

//------------------------------------------------------------------------------
void TileTransfer::Build(const TransferFunction& function, double longest)
{
  const std::vector<float>& positions = function.GetPositions();
  const std::vector<float>& values = function.GetValues();
  const double greatest = longest > 0.0 ? DeepestRay / longest : DeepestRay;
  this->NumberOfPieces = function.GetNumberOfNodes() - 1;
  this->SearchSteps = 0;
  while (1 << this->SearchSteps < this->NumberOfPieces)
  {
    ++this->SearchSteps;
  }
  const std::size_t size = (std::size_t(1) << this->SearchSteps) + Padding;
  this->Bounds.assign(size, 3e38f);
  std::copy(positions.begin(), positions.end(), this->Bounds.begin());
  this->GreatestExtinction = 0.0f;
  for (int k = 0; k < 4; ++k)
  {
    this->Slopes[k].assign(size, 0.0f);
    this->Offsets[k].assign(size, 0.0f);
    for (int piece = 0; piece < this->NumberOfPieces; ++piece)
    {
      const double width = double(positions[piece + 1]) - positions[piece];
      double ends[2] = { values[4 * piece + k], values[4 * piece + 4 + k] };
      for (double& end : ends)
      {
        end = k == 3 ? std::min(end, greatest) : end;
      }
      // Two nodes at one place: a step, and no piece of any length.
      const double slope = width > 0.0 ? (ends[1] - ends[0]) / width : 0.0;
      this->Slopes[k][piece] = static_cast<float>(slope);
      this->Offsets[k][piece] = static_cast<float>(ends[0] - slope * positions[piece]);
      this->GreatestExtinction =
        k == 3 ? std::max({ this->GreatestExtinction, float(ends[0]), float(ends[1]) }) : 0.0f;
    }
  }
}
