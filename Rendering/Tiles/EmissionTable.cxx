#include "EmissionTable.h"

#include "TransferFunction.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
void EmissionTable::Build(const TransferFunction& function)
{
  const std::vector<float>& positions = function.GetPositions();
  const std::vector<float>& values = function.GetValues();
  this->NumberOfPieces = function.GetNumberOfNodes() - 1;
  this->SearchSteps = 0;
  while (1 << this->SearchSteps < this->NumberOfPieces)
  {
    ++this->SearchSteps;
  }
  const std::size_t size = (std::size_t(1) << this->SearchSteps) + Padding;
  this->Bounds.assign(size, 3e38f);
  std::copy(positions.begin(), positions.end(), this->Bounds.begin());
  this->Origins.assign(size, 0.0f);
  this->GreatestEmission = this->GreatestSlope = 0.0f;
  for (int piece = 0; piece < this->NumberOfPieces; ++piece)
  {
    // The first piece is constant and begins at the end of the world.
    this->Origins[piece] = positions[piece == 0 ? 1 : piece];
  }
  for (int k = 0; k < 3; ++k)
  {
    this->C0[k].assign(size, 0.0f);
    this->C1[k].assign(size, 0.0f);
    this->C2[k].assign(size, 0.0f);
    for (int piece = 0; piece < this->NumberOfPieces; ++piece)
    {
      const double width = double(positions[piece + 1]) - positions[piece];
      const float* ends = &values[4 * static_cast<std::size_t>(piece)];
      // Two nodes at one place: a step, and no piece of any length.
      const double perWidth = width > 0.0 ? 1.0 / width : 0.0;
      const double color = ends[k], colorSlope = (double(ends[4 + k]) - color) * perWidth;
      const double depth = ends[3], depthSlope = (double(ends[7]) - depth) * perWidth;
      this->C0[k][piece] = static_cast<float>(color * depth);
      this->C1[k][piece] = static_cast<float>(color * depthSlope + colorSlope * depth);
      this->C2[k][piece] = static_cast<float>(colorSlope * depthSlope);
      const float greatest = std::max(ends[k], ends[4 + k]) * std::max(ends[3], ends[7]);
      this->GreatestEmission = std::max(this->GreatestEmission, greatest);
      const double atEnd = this->C1[k][piece] + 2.0 * this->C2[k][piece] * width;
      this->GreatestSlope = std::max({ this->GreatestSlope, std::abs(this->C1[k][piece]),
        width > 0.0 ? static_cast<float>(std::abs(atEnd)) : 0.0f });
    }
  }
}
