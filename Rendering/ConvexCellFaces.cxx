#include "ConvexCellFaces.h"

#include "vtkCellType.h"
#include "vtkHexagonalPrism.h"
#include "vtkHexahedron.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPentagonalPrism.h"
#include "vtkPyramid.h"
#include "vtkSMPTools.h"
#include "vtkTetra.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWedge.h"

#include <algorithm>
#include <numeric>

namespace
{
using Rows = ConvexCellFaces::Rows;

constexpr int CellsPerChunk = 16384;

// Of a cell type with a fixed number of corners: its faces, by VTK's tables.
struct CellShape
{
  const vtkIdType* (*GetFace)(vtkIdType) = nullptr;
  std::vector<int> FaceSizes;
};

const CellShape& ShapeOf(int type)
{
  static const CellShape none;
  static const CellShape tetrahedron{ &vtkTetra::GetFaceArray, { 3, 3, 3, 3 } };
  static const CellShape pyramid{ &vtkPyramid::GetFaceArray, { 4, 3, 3, 3, 3 } };
  static const CellShape wedge{ &vtkWedge::GetFaceArray, { 3, 3, 4, 4, 4 } };
  static const CellShape hexahedron{ &vtkHexahedron::GetFaceArray, { 4, 4, 4, 4, 4, 4 } };
  static const CellShape pentagonal{ &vtkPentagonalPrism::GetFaceArray, { 5, 5, 4, 4, 4, 4, 4 } };
  static const CellShape hexagonal{ &vtkHexagonalPrism::GetFaceArray, { 6, 6, 4, 4, 4, 4, 4, 4 } };
  switch (type)
  {
    case VTK_TETRA:
      return tetrahedron;
    case VTK_PYRAMID:
      return pyramid;
    case VTK_WEDGE:
      return wedge;
    case VTK_HEXAHEDRON:
      return hexahedron;
    case VTK_PENTAGONAL_PRISM:
      return pentagonal;
    case VTK_HEXAGONAL_PRISM:
      return hexagonal;
    default:
      return none;
  }
}

// The same loop for both cells of a face, in whichever direction they list it.
void StartAtSmallest(std::vector<int>& loop)
{
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  if (loop.size() > 2 && loop.back() < loop[1])
  {
    std::reverse(loop.begin() + 1, loop.end());
  }
}

// A range of cells and their faces, faces numbered as they come.
class Chunk
{
public:
  void Read(vtkUnstructuredGrid* cells, vtkIdType begin, vtkIdType end);

  Rows Corners;
  Rows Loops;
  std::vector<int> FacesPerCell;

private:
  void ReadFixed(vtkIdList* ids, const CellShape& shape);
  void ReadPolyhedron(vtkIdList* stream);
  void TakeLoop();

  std::vector<int> Loop;
};

//------------------------------------------------------------------------------
void Chunk::TakeLoop()
{
  StartAtSmallest(this->Loop);
  this->Loops.Append(this->Loop);
  this->Loop.clear();
}

//------------------------------------------------------------------------------
void Chunk::ReadFixed(vtkIdList* ids, const CellShape& shape)
{
  for (size_t face = 0; face < shape.FaceSizes.size(); ++face)
  {
    const vtkIdType* corners = shape.GetFace(static_cast<vtkIdType>(face));
    for (int i = 0; i < shape.FaceSizes[face]; ++i)
    {
      this->Loop.push_back(static_cast<int>(ids->GetId(corners[i])));
    }
    this->TakeLoop();
  }
}

//------------------------------------------------------------------------------
void Chunk::ReadPolyhedron(vtkIdList* stream)
{
  vtkIdType at = 1;
  for (vtkIdType face = 0; face < stream->GetId(0); ++face)
  {
    const vtkIdType last = at + stream->GetId(at);
    while (at < last)
    {
      this->Loop.push_back(static_cast<int>(stream->GetId(++at)));
    }
    ++at;
    this->TakeLoop();
  }
}

//------------------------------------------------------------------------------
void Chunk::Read(vtkUnstructuredGrid* cells, vtkIdType begin, vtkIdType end)
{
  vtkNew<vtkIdList> ids;
  std::vector<int> corners;
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    cells->GetCellPoints(cell, ids);
    corners.assign(ids->begin(), ids->end());
    this->Corners.Append(corners);
    const int before = this->Loops.GetNumberOfRows();
    const int type = cells->GetCellType(cell);
    if (type == VTK_POLYHEDRON)
    {
      cells->GetFaceStream(cell, ids);
      this->ReadPolyhedron(ids);
    }
    else
    {
      this->ReadFixed(ids, ShapeOf(type));
    }
    this->FacesPerCell.push_back(this->Loops.GetNumberOfRows() - before);
  }
}

// Faces in bins by their smallest point id.
Rows BinLoops(const Rows& loops)
{
  int bins = 0;
  for (int face = 0; face < loops.GetNumberOfRows(); ++face)
  {
    bins = std::max(bins, *loops.GetRow(face) + 1);
  }
  Rows binned;
  binned.Offsets.assign(static_cast<size_t>(bins) + 1, 0);
  for (int face = 0; face < loops.GetNumberOfRows(); ++face)
  {
    ++binned.Offsets[*loops.GetRow(face) + 1];
  }
  std::partial_sum(binned.Offsets.begin(), binned.Offsets.end(), binned.Offsets.begin());
  std::vector<int> next(binned.Offsets.begin(), binned.Offsets.end());
  binned.Values.resize(static_cast<size_t>(loops.GetNumberOfRows()));
  for (int face = 0; face < loops.GetNumberOfRows(); ++face)
  {
    binned.Values[next[*loops.GetRow(face)]++] = face;
  }
  return binned;
}

bool IsSameLoop(const Rows& loops, int a, int b)
{
  const int size = loops.GetSize(a);
  return size == loops.GetSize(b) &&
         std::equal(loops.GetRow(a), loops.GetRow(a) + size, loops.GetRow(b));
}
}

//------------------------------------------------------------------------------
void ConvexCellFaces::Rows::Append(const std::vector<int>& row)
{
  this->Values.insert(this->Values.end(), row.begin(), row.end());
  this->Offsets.push_back(static_cast<int>(this->Values.size()));
}

//------------------------------------------------------------------------------
void ConvexCellFaces::Rows::Append(const Rows& other)
{
  const int start = this->Offsets.back();
  std::transform(other.Offsets.begin() + 1, other.Offsets.end(), std::back_inserter(this->Offsets),
    [start](int offset) { return start + offset; });
  this->Values.insert(this->Values.end(), other.Values.begin(), other.Values.end());
}

//------------------------------------------------------------------------------
void ConvexCellFaces::Build(vtkUnstructuredGrid* cells)
{
  *this = ConvexCellFaces();
  const vtkIdType count = cells->GetNumberOfCells();
  std::vector<Chunk> chunks(static_cast<size_t>((count + CellsPerChunk - 1) / CellsPerChunk));
  vtkSMPTools::For(0, static_cast<vtkIdType>(chunks.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType chunk = begin; chunk < end; ++chunk)
      {
        const vtkIdType first = chunk * CellsPerChunk;
        chunks[chunk].Read(cells, first, std::min(count, first + CellsPerChunk));
      }
    });
  Rows loops;
  for (const Chunk& chunk : chunks)
  {
    this->Corners.Append(chunk.Corners);
    loops.Append(chunk.Loops);
    for (const int faces : chunk.FacesPerCell)
    {
      this->Faces.Offsets.push_back(this->Faces.Offsets.back() + faces);
    }
  }
  this->MergeLoops(loops);
}

//------------------------------------------------------------------------------
void ConvexCellFaces::MergeLoops(const Rows& loops)
{
  const Rows bins = BinLoops(loops);
  std::vector<int> first(static_cast<size_t>(loops.GetNumberOfRows()));
  vtkSMPTools::For(0, bins.GetNumberOfRows(),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType bin = begin; bin < end; ++bin)
      {
        const int* members = bins.GetRow(static_cast<int>(bin));
        for (int i = 0; i < bins.GetSize(static_cast<int>(bin)); ++i)
        {
          const int* same = std::find_if(
            members, members + i, [&](int other) { return IsSameLoop(loops, other, members[i]); });
          first[members[i]] = *same;
        }
      }
    });
  std::vector<int> number(first.size());
  this->Faces.Values.resize(first.size());
  for (int face = 0; face < loops.GetNumberOfRows(); ++face)
  {
    if (first[face] == face)
    {
      number[face] = this->GetNumberOfFaces();
      this->Loops.Append(
        std::vector<int>(loops.GetRow(face), loops.GetRow(face) + loops.GetSize(face)));
    }
    this->Faces.Values[face] = number[first[face]];
  }
}
