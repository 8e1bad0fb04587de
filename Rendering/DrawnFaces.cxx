#include "DrawnFaces.h"

#include "ConvexCellFaces.h"
#include "ConvexCellSelection.h"
#include "FacePieces.h"
#include "ScalarField.h"

#include <algorithm>
#include <limits>

//------------------------------------------------------------------------------
void DrawnFaces::Build(
  const ConvexCellFaces& cells, const FacePieces& pieces, const ConvexCellSelection& selection)
{
  std::vector<unsigned char> drawn(static_cast<size_t>(cells.GetNumberOfFaces()), 0);
  for (const unsigned int cell : selection.DrawnCells)
  {
    const int row = static_cast<int>(cell);
    for (int i = 0; i < cells.Faces.GetSize(row); ++i)
    {
      drawn[cells.Faces.GetRow(row)[i]] = 1;
    }
  }
  this->Pieces.clear();
  for (int face = 0; face < cells.GetNumberOfFaces(); ++face)
  {
    for (int piece = pieces.Offsets[face]; drawn[face] && piece < pieces.Offsets[face + 1]; ++piece)
    {
      this->Pieces.push_back(static_cast<unsigned int>(piece));
    }
  }
}

//------------------------------------------------------------------------------
std::vector<float> DrawnFaces::CellScalars(const ConvexCellFaces& cells, const FacePieces& pieces,
  const ConvexCellSelection& selection, const ScalarField& scalars, bool findLeast)
{
  const float none = std::numeric_limits<float>::max() * (findLeast ? 1.0f : -1.0f);
  std::vector<float> values(4 * static_cast<size_t>(pieces.GetNumberOfPieces()), none);
  for (const unsigned int cell : selection.DrawnCells)
  {
    const int row = static_cast<int>(cell);
    const float scalar = scalars.Values[cell];
    for (int i = 0; i < cells.Faces.GetSize(row); ++i)
    {
      const int face = cells.Faces.GetRow(row)[i];
      for (int at = 4 * pieces.Offsets[face]; at < 4 * pieces.Offsets[face + 1]; ++at)
      {
        values[at] = findLeast ? std::min(values[at], scalar) : std::max(values[at], scalar);
      }
    }
  }
  return values;
}
