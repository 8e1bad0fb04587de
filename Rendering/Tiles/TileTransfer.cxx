#include "TileTransfer.h"

#include "TransferFunction.h"

#include <algorithm>
#include <cmath>

namespace
{
// Optical depths beyond this leave nothing of the light, and would leave the range of a float.
constexpr double DeepestRay = 1e9;
// Share of its value by which a node may lie beside the line of those before it, and of its
// position.
constexpr double Straight = 1e-6;
constexpr double FloatStep = 1.2e-7;
// A scalar beyond all others.
constexpr float Everything = 1e30f;
}

//------------------------------------------------------------------------------
void TileTransfer::Build(const TransferFunction& function, double longest)
{
  const std::vector<float>& positions = function.GetPositions();
  const std::vector<float>& values = function.GetValues();
  const double opaque = longest > 0.0 ? DeepestRay / longest : DeepestRay;
  this->GreatestExtinction = 0.0f;
  this->Allocate(positions.size());
  this->NumberOfPieces = 0;
  for (std::size_t node = 0; node + 1 < positions.size(); ++node)
  {
    Node ends[2];
    for (std::size_t end = 0; end < 2; ++end)
    {
      std::copy_n(&values[4 * (node + end)], 4, ends[end].Values.begin());
      ends[end].Values[3] = std::min(ends[end].Values[3], opaque);
      ends[end].Position = positions[node + end];
      this->GreatestExtinction =
        std::max(this->GreatestExtinction, static_cast<float>(ends[end].Values[3]));
    }
    this->Append(ends[0], ends[1]);
  }
  this->Bounds[this->NumberOfPieces] = positions.back();
  this->SearchSteps = 0;
  while (1 << this->SearchSteps < this->NumberOfPieces)
  {
    ++this->SearchSteps;
  }
  this->FindSeen();
  this->FillLines();
}

//------------------------------------------------------------------------------
void TileTransfer::Allocate(std::size_t nodes)
{
  std::size_t size = 1;
  while (size < nodes)
  {
    size *= 2;
  }
  size += Padding;
  this->Bounds.assign(size, 3e38f);
  for (int k = 0; k < 4; ++k)
  {
    this->Slopes[k].assign(size, 0.0f);
    this->Offsets[k].assign(size, 0.0f);
  }
  this->SeenFrom.assign(size, -Everything);
  this->SeenTo.assign(size, Everything);
}

//------------------------------------------------------------------------------
void TileTransfer::Append(const Node& first, const Node& last)
{
  const double width = last.Position - first.Position;
  // Two nodes at one place: a step, and no piece of any length.
  if (!(width > 0.0) || (this->NumberOfPieces > 0 && this->Continues(first, last)))
  {
    return;
  }
  const int piece = this->NumberOfPieces++;
  this->Bounds[piece] = static_cast<float>(first.Position);
  this->LastStart = first;
  for (int k = 0; k < 4; ++k)
  {
    const double slope = (last.Values[k] - first.Values[k]) / width;
    this->LastSlopes[k] = slope;
    this->Slopes[k][piece] = static_cast<float>(slope);
    this->Offsets[k][piece] = static_cast<float>(first.Values[k] - slope * first.Position);
  }
}

//------------------------------------------------------------------------------
bool TileTransfer::Continues(const Node& first, const Node& last) const
{
  for (int k = 0; k < 4; ++k)
  {
    const double slope = this->LastSlopes[k];
    const double greatest = std::max(std::abs(first.Values[k]), std::abs(last.Values[k]));
    for (const Node& node : { first, last })
    {
      const double line =
        this->LastStart.Values[k] + slope * (node.Position - this->LastStart.Position);
      const double step = FloatStep * std::abs(slope * node.Position);
      if (!(std::abs(line - node.Values[k]) <= Straight * greatest + step))
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void TileTransfer::FindSeen()
{
  auto isSeen = [this](int piece)
  { return this->Slopes[3][piece] != 0.0f || this->Offsets[3][piece] > 0.0f; };
  this->HasTransparent = false;
  float from = Everything, to = -Everything;
  for (int piece = this->NumberOfPieces - 1; piece >= 0; --piece)
  {
    from = isSeen(piece) ? this->Bounds[piece] : from;
    this->SeenFrom[piece] = isSeen(piece) ? -Everything : from;
    this->HasTransparent = this->HasTransparent || !isSeen(piece);
  }
  for (int piece = 0; piece < this->NumberOfPieces; ++piece)
  {
    to = isSeen(piece) ? this->Bounds[piece + 1] : to;
    this->SeenTo[piece] = isSeen(piece) ? Everything : to;
  }
}

//------------------------------------------------------------------------------
void TileTransfer::FillLines()
{
  this->Lines.assign(this->Bounds.size(), Line{});
  for (int piece = 0; piece < this->NumberOfPieces; ++piece)
  {
    Line& line = this->Lines[piece];
    line.Low = this->Bounds[piece];
    line.High = this->Bounds[piece + 1];
    line.HalfSlope = 0.5f * this->Slopes[3][piece];
    line.Offset = this->Offsets[3][piece];
    for (int k = 0; k < 3; ++k)
    {
      line.ColorSlopes[k] = this->Slopes[k][piece];
      line.ColorOffsets[k] = this->Offsets[k][piece];
    }
  }
}
