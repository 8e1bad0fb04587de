#include "CellComplexReader.h"

#include "CellComplexBuilder.h"
#include "CoincidentPoints.h"
#include "PointCoordinates.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
constexpr vtkIdType CellsPerChunk = 16384;

/** Reads cells; one for all threads. */
class Reader
{
public:
  Reader(vtkDataSet* input, CellComplex& complex)
    : Input(input)
    , Complex(complex)
    , Imaginary(vtkUnsignedCharArray::SafeDownCast(input->GetCellData()->GetArray("Imaginary")))
  {
  }

  void ReadPoints();
  std::vector<FaceTriangle> ReadCells();

private:
  void ReadRange(vtkIdType begin, vtkIdType end, CellFaces& faces);
  bool TakePoints(vtkIdList* ids, std::vector<int>& points) const;
  void AddFaces(vtkIdType cell, vtkGenericCell* generic, const std::vector<int>& points,
    CellFaces& faces) const;
  void FindTypes();
  void PlaceCells();
  void SetCenter(vtkIdType cell, const std::vector<int>& points);
  void FindCenterBox();

  vtkDataSet* Input;
  CellComplex& Complex;
  vtkUnsignedCharArray* Imaginary;
  std::vector<vtkIdType> Canonical;
  // Of each cell type that the input has: whether it is a linear cell of three dimensions.
  std::array<bool, 256> HasFaces{};
};

//------------------------------------------------------------------------------
void Reader::ReadPoints()
{
  const vtkIdType count = this->Input->GetNumberOfPoints();
  std::vector<double>& points = this->Complex.Points;
  points.resize(3 * static_cast<size_t>(count));
  this->Canonical.resize(static_cast<size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    this->Input->GetPoint(i, &points[3 * i]);
    const bool finite =
      std::all_of(&points[3 * i], &points[3 * i] + 3, [](double x) { return std::isfinite(x); });
    this->Canonical[i] = finite ? i : -1;
  }
  vtkNew<vtkDoubleArray> array;
  array->SetNumberOfComponents(3);
  array->SetArray(points.data(), static_cast<vtkIdType>(points.size()), 1);
  CoincidentPoints::Merge(PointCoordinates(array), count, this->Canonical.data());
}

//------------------------------------------------------------------------------
bool Reader::TakePoints(vtkIdList* ids, std::vector<int>& points) const
{
  points.clear();
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    const vtkIdType id = ids->GetId(i);
    if (id < 0 || id >= static_cast<vtkIdType>(this->Canonical.size()) || this->Canonical[id] < 0)
    {
      return false;
    }
    points.push_back(static_cast<int>(this->Canonical[id]));
  }
  return true;
}

//------------------------------------------------------------------------------
void Reader::FindTypes()
{
  std::array<bool, 256> seen{};
  for (vtkIdType cell = 0; cell < this->Input->GetNumberOfCells(); ++cell)
  {
    const int type = this->Input->GetCellType(cell);
    const auto index = static_cast<unsigned char>(type);
    if (!seen[index])
    {
      seen[index] = true;
      const auto example = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
      this->HasFaces[index] = example && example->IsLinear() && example->GetCellDimension() == 3;
    }
  }
}

//------------------------------------------------------------------------------
void Reader::PlaceCells()
{
  // Cells that are not read stay here: the origin may be far from the mesh.
  const auto finite = std::find_if(
    this->Canonical.begin(), this->Canonical.end(), [](vtkIdType id) { return id >= 0; });
  if (finite != this->Canonical.end())
  {
    const double* point = &this->Complex.Points[3 * static_cast<size_t>(*finite)];
    for (size_t i = 0; i < this->Complex.Centers.size(); ++i)
    {
      this->Complex.Centers[i] = point[i % 3];
    }
  }
}

//------------------------------------------------------------------------------
void Reader::SetCenter(vtkIdType cell, const std::vector<int>& points)
{
  double* center = &this->Complex.Centers[3 * cell];
  std::fill_n(center, 3, 0.0);
  for (const int point : points)
  {
    for (int i = 0; i < 3; ++i)
    {
      center[i] += this->Complex.Points[3 * static_cast<size_t>(point) + i] / points.size();
    }
  }
}

//------------------------------------------------------------------------------
void Reader::FindCenterBox()
{
  const std::vector<double>& centers = this->Complex.Centers;
  for (size_t i = 0; i < centers.size(); i += 3)
  {
    this->Complex.CenterBox.AddPoint(centers[i], centers[i + 1], centers[i + 2]);
  }
}

//------------------------------------------------------------------------------
void Reader::AddFaces(
  vtkIdType cell, vtkGenericCell* generic, const std::vector<int>& points, CellFaces& faces) const
{
  const size_t first = faces.Triangles.size();
  std::vector<int> face;
  for (int f = 0; f < generic->GetNumberOfFaces(); ++f)
  {
    vtkCell* polygon = generic->GetFace(f);
    if (!this->TakePoints(polygon->GetPointIds(), face))
    {
      continue;
    }
    if (polygon->GetCellType() == VTK_PIXEL)
    {
      std::swap(face[2], face[3]);
    }
    faces.AddFace(static_cast<int>(cell), face, points);
  }
  faces.SettleSides(first);
}

//------------------------------------------------------------------------------
void Reader::ReadRange(vtkIdType begin, vtkIdType end, CellFaces& faces)
{
  vtkNew<vtkGenericCell> generic;
  vtkNew<vtkIdList> ids;
  std::vector<int> points;
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    if (this->Imaginary && this->Imaginary->GetValue(cell) != 0)
    {
      continue;
    }
    const int type = this->Input->GetCellType(cell);
    this->Input->GetCellPoints(cell, ids);
    if (!this->TakePoints(ids, points))
    {
      continue;
    }
    if (type == VTK_TETRA && points.size() == 4)
    {
      faces.AddTetrahedron(static_cast<int>(cell), points.data());
    }
    else if (this->HasFaces[static_cast<unsigned char>(type)])
    {
      this->Input->GetCell(cell, generic);
      this->AddFaces(cell, generic, points, faces);
    }
    this->SetCenter(cell, points);
  }
}

//------------------------------------------------------------------------------
std::vector<FaceTriangle> Reader::ReadCells()
{
  const vtkIdType cells = this->Input->GetNumberOfCells();
  this->Complex.NumberOfCells = static_cast<int>(cells);
  this->Complex.Centers.assign(3 * static_cast<size_t>(cells), 0.0);
  this->PlaceCells();
  this->FindTypes();
  if (cells > 0)
  {
    // The first call may build what all threads then read.
    vtkNew<vtkGenericCell> generic;
    this->Input->GetCell(0, generic);
  }
  const vtkIdType chunks = (cells + CellsPerChunk - 1) / CellsPerChunk;
  std::vector<CellFaces> parts(static_cast<size_t>(chunks), CellFaces(this->Complex.Points.data()));
  vtkSMPTools::For(0, chunks, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType chunk = begin; chunk < end; ++chunk)
      {
        this->ReadRange(
          chunk * CellsPerChunk, std::min(cells, (chunk + 1) * CellsPerChunk), parts[chunk]);
      }
    });
  this->FindCenterBox();
  std::vector<FaceTriangle> triangles;
  for (CellFaces& part : parts)
  {
    triangles.insert(triangles.end(), part.Triangles.begin(), part.Triangles.end());
    part.Triangles = std::vector<FaceTriangle>();
  }
  return triangles;
}
}

namespace CellComplexReader
{
//------------------------------------------------------------------------------
void Read(vtkDataSet* input, CellComplex& complex)
{
  complex = CellComplex();
  Reader reader(input, complex);
  reader.ReadPoints();
  CellComplexBuilder::Build(reader.ReadCells(), complex);
}
}
