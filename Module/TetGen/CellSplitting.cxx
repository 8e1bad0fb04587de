#include "CellSplitting.h"

#include "CarriedData.h"
#include "CoincidentPoints.h"
#include "ConcaveCells.h"
#include "PointCoordinates.h"
#include "PolyhedronSurface.h"
#include "VTKVersions.h"
#include "vtkCellData.h"
#include "vtkConvexCells.h"
#include "vtkIdTypeArray.h"
#include "vtkMeanValueCoordinatesInterpolator.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace
{
// Goes along with the points of a copy of the input, to tell which are which.
const char* const PointIdsName = "vtkCellProjectionPointIds";

bool IsHidden(vtkDataSetAttributes* attributes, vtkIdType id, unsigned char kinds)
{
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    attributes->GetArray(vtkDataSetAttributes::GhostArrayName()));
  return ghosts && (ghosts->GetValue(id) & kinds) != 0;
}

vtkSmartPointer<vtkPoints> PointsOf(const TetGenMesh& mesh, vtkIdType count)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(i, &mesh.Points[3 * i]);
  }
  return points;
}
}

//------------------------------------------------------------------------------
CellSplitting::CellSplitting(vtkUnstructuredGrid* input)
  : Input(input)
{
}

//------------------------------------------------------------------------------
CellSplitting::~CellSplitting() = default;

//------------------------------------------------------------------------------
void CellSplitting::Run(vtkUnstructuredGrid* output)
{
  this->SplitConvexCells();
  TetrahedraOutput tetrahedra;
  this->CutLeftOut(tetrahedra);
  this->NumberOfNewPoints = static_cast<vtkIdType>(tetrahedra.NewPoints.size());
  if (this->NumberOfCutCells == 0)
  {
    output->ShallowCopy(this->Split);
  }
  else
  {
    this->TakeTetrahedra(tetrahedra);
    const auto whole =
      CarriedData::WholeArrays(this->Input->GetCellData(), this->Input->GetNumberOfCells());
    TransferredData::Fill(tetrahedra, this->Split, whole, output);
  }
}

//------------------------------------------------------------------------------
void CellSplitting::SplitConvexCells()
{
  vtkNew<vtkUnstructuredGrid> copy;
  copy->ShallowCopy(this->Input);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(PointIdsName);
  ids->SetNumberOfValues(copy->GetNumberOfPoints());
  for (vtkIdType i = 0; i < copy->GetNumberOfPoints(); ++i)
  {
    ids->SetValue(i, i);
  }
  copy->GetPointData()->AddArray(ids);
  vtkNew<vtkConvexCells> convex;
  convex->SetInputData(copy);
  convex->TetrahedraOnlyOn();
  convex->Update();
  this->Split = convex->GetOutput();
  this->NumberOfSkippedCells = convex->GetNumberOfSkippedCells();
  this->NumberPoints();
  this->Split->GetPointData()->RemoveArray(PointIdsName);
}

//------------------------------------------------------------------------------
void CellSplitting::NumberPoints()
{
  const vtkIdType count = this->Input->GetNumberOfPoints();
  std::vector<vtkIdType> canonical(static_cast<size_t>(count), -1);
  std::vector<vtkIdType> numbers(static_cast<size_t>(count), -1);
  auto* ids =
    vtkIdTypeArray::SafeDownCast(this->Split->GetPointData()->GetAbstractArray(PointIdsName));
  for (vtkIdType i = 0; ids && i < ids->GetNumberOfTuples(); ++i)
  {
    // Points that vtkConvexCells made are no point of the input.
    const vtkIdType id = ids->GetValue(i);
    const double* made = this->Split->GetPoint(i);
    double x[3];
    if (id >= 0 && id < count)
    {
      this->Input->GetPoint(id, x);
      numbers[id] = std::equal(x, x + 3, made) ? i : numbers[id];
    }
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double* x = this->Input->GetPoint(i);
    const bool counts =
      std::all_of(x, x + 3, [](double c) { return std::isfinite(c); }) &&
      !IsHidden(this->Input->GetPointData(), i, vtkDataSetAttributes::HIDDENPOINT);
    canonical[i] = counts ? i : -1;
  }
  if (count > 0)
  {
    const PointCoordinates points(this->Input->GetPoints()->GetData());
    CoincidentPoints::Merge(points, count, canonical.data());
  }
  this->PointNumbers.resize(static_cast<size_t>(count));
  std::transform(canonical.begin(), canonical.end(), this->PointNumbers.begin(),
    [&](vtkIdType id) { return id < 0 ? -1 : numbers[id]; });
}

//------------------------------------------------------------------------------
void CellSplitting::TakeTetrahedra(TetrahedraOutput& tetrahedra) const
{
  // Those of TetGen are there; all go in the order of the input's cells.
  TetrahedraOutput ordered;
  auto* sources = vtkIdTypeArray::SafeDownCast(this->Split->GetCellData()->GetArray("SourceCell"));
  size_t next = 0;
  const auto takeBefore = [&](vtkIdType cell)
  {
    for (; next < tetrahedra.Tetrahedra.size() && tetrahedra.SourceCells[next] < cell; ++next)
    {
      ordered.Tetrahedra.push_back(tetrahedra.Tetrahedra[next]);
      ordered.SourceCells.push_back(tetrahedra.SourceCells[next]);
    }
  };
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < this->Split->GetNumberOfCells(); ++i)
  {
    takeBefore(sources->GetValue(i));
    this->Split->GetCellPoints(i, ids);
    std::array<int, 4> corners;
    std::copy_n(ids->begin(), 4, corners.begin());
    ordered.Tetrahedra.push_back(corners);
    ordered.SourceCells.push_back(sources->GetValue(i));
  }
  takeBefore(this->Input->GetNumberOfCells());
  ordered.NewPoints = std::move(tetrahedra.NewPoints);
  tetrahedra = std::move(ordered);
}

//------------------------------------------------------------------------------
void CellSplitting::CutLeftOut(TetrahedraOutput& tetrahedra)
{
  auto* sources = vtkIdTypeArray::SafeDownCast(this->Split->GetCellData()->GetArray("SourceCell"));
  std::vector<char> isSplit(static_cast<size_t>(this->Input->GetNumberOfCells()), 0);
  for (vtkIdType i = 0; sources && i < sources->GetNumberOfTuples(); ++i)
  {
    isSplit[sources->GetValue(i)] = 1;
  }
  vtkNew<vtkIdList> stream;
  PolyhedronSurface surface;
  constexpr unsigned char notHere =
    vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  auto* imaginary =
    vtkUnsignedCharArray::SafeDownCast(this->Input->GetCellData()->GetArray("Imaginary"));
  for (vtkIdType cell = 0; cell < this->Input->GetNumberOfCells(); ++cell)
  {
    if (!isSplit[cell] && this->Input->GetCellType(cell) == VTK_POLYHEDRON &&
        !IsHidden(this->Input->GetCellData(), cell, notHere) &&
        !(imaginary && imaginary->GetValue(cell)) && this->ReadSurface(cell, stream, surface))
    {
      this->CutCell(cell, surface, tetrahedra);
    }
  }
}

//------------------------------------------------------------------------------
bool CellSplitting::ReadSurface(vtkIdType cell, vtkIdList* stream, PolyhedronSurface& surface) const
{
  if (!HasFaceStream(this->Input, cell, stream))
  {
    return false;
  }
  this->Input->GetFaceStream(cell, stream);
  return surface.Read(stream->GetPointer(0), stream->GetNumberOfIds(), this->PointNumbers.data(),
           this->Input->GetNumberOfPoints()) &&
         !surface.GetIds().empty() && surface.GetIds().front() >= 0 &&
         surface.Orient() == PolyhedronSurface::Defect::None;
}

//------------------------------------------------------------------------------
void CellSplitting::CutCell(
  vtkIdType cell, PolyhedronSurface& surface, TetrahedraOutput& tetrahedra)
{
  std::vector<double> points;
  for (const vtkIdType id : surface.GetIds())
  {
    const double* x = this->Split->GetPoint(id);
    points.insert(points.end(), x, x + 3);
  }
  const ConcaveCell cut = ConcaveCells::Cut(surface, points);
  if (cut.Mesh.Failure.empty())
  {
    this->AddCell(cell, surface, cut, tetrahedra);
    ++this->NumberOfCutCells;
    --this->NumberOfSkippedCells;
  }
  else if (this->NumberOfFailedCells++ == 0)
  {
    this->FirstFailedCell = cell;
    this->FirstFailure = cut.Mesh.Failure;
  }
}

//------------------------------------------------------------------------------
void CellSplitting::AddCell(vtkIdType cell, const PolyhedronSurface& surface,
  const ConcaveCell& cut, TetrahedraOutput& tetrahedra) const
{
  const std::vector<vtkIdType>& ids = surface.GetIds();
  const auto corners = static_cast<vtkIdType>(ids.size());
  const auto first = static_cast<int>(
    this->Split->GetNumberOfPoints() + static_cast<vtkIdType>(tetrahedra.NewPoints.size()));
  const vtkSmartPointer<vtkPoints> points = PointsOf(cut.Mesh, corners);
  vtkNew<vtkIdList> triangles;
  for (const std::array<int, 3>& triangle : cut.Triangles)
  {
    std::for_each(triangle.begin(), triangle.end(),
      [&triangles](int corner) { triangles->InsertNextId(corner); });
  }
  for (size_t i = ids.size(); 3 * i < cut.Mesh.Points.size(); ++i)
  {
    NewPoint point;
    std::copy_n(&cut.Mesh.Points[3 * i], 3, point.Position.begin());
    point.Ids = ids;
    point.Weights.resize(ids.size());
    vtkMeanValueCoordinatesInterpolator::ComputeInterpolationWeights(
      point.Position.data(), points, triangles, point.Weights.data());
    tetrahedra.NewPoints.push_back(std::move(point));
  }
  for (std::array<int, 4> tetrahedron : cut.Mesh.Tetrahedra)
  {
    for (int& corner : tetrahedron)
    {
      corner = corner < corners ? static_cast<int>(ids[corner])
                                : first + corner - static_cast<int>(corners);
    }
    tetrahedra.Tetrahedra.push_back(tetrahedron);
    tetrahedra.SourceCells.push_back(cell);
  }
}
