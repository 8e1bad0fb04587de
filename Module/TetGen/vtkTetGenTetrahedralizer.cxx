#include "vtkTetGenTetrahedralizer.h"

#include "CarriedData.h"
#include "CellComplex.h"
#include "CellComplexReader.h"
#include "CellSplitting.h"
#include "HullFilling.h"
#include "ImaginaryGrid.h"
#include "SourceLocator.h"
#include "TetGenMesher.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <numeric>

vtkStandardNewMacro(vtkTetGenTetrahedralizer);

namespace
{
// Rounding leaves 1e-14; more is a boundary that runs through itself.
constexpr double LargestVolumeError = 1e-9;

TetGenSurface BoundaryOf(vtkUnstructuredGrid* tetrahedra)
{
  CellComplex complex;
  CellComplexReader::Read(tetrahedra, complex);
  TetGenSurface surface;
  surface.Points = std::move(complex.Points);
  for (const CellComplex::BoundaryTriangle& triangle : complex.Boundary)
  {
    surface.Triangles.push_back({ { triangle.Points[0], triangle.Points[1], triangle.Points[2] } });
  }
  return surface;
}

std::vector<double> PointsOf(vtkUnstructuredGrid* grid)
{
  std::vector<double> points(3 * static_cast<size_t>(grid->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    grid->GetPoint(i, &points[3 * i]);
  }
  return points;
}

// `split`: the cells of the input as tetrahedra, with the points that `mesh` goes on from.
void TakeMesh(const TetGenMesh& mesh, vtkUnstructuredGrid* input, vtkUnstructuredGrid* split,
  vtkUnstructuredGrid* output)
{
  const SourceLocator locator(split);
  TetrahedraOutput tetrahedra;
  tetrahedra.Tetrahedra = mesh.Tetrahedra;
  tetrahedra.SourceCells = locator.FindSources(mesh);
  tetrahedra.NewPoints = locator.FindNewPoints(mesh);
  tetrahedra.UsedPointsOnly = true;
  const auto cells = CarriedData::WholeArrays(input->GetCellData(), input->GetNumberOfCells());
  TransferredData::Fill(tetrahedra, split, cells, output);
}
}

//------------------------------------------------------------------------------
int vtkTetGenTetrahedralizer::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  this->NumberOfCutCells = this->NumberOfFailedCells = this->NumberOfSkippedCells = 0;
  this->NumberOfNewPoints = this->NumberOfImaginaryCells = 0;
  this->FellBack = false;
  if (this->Mode == FILL_HULL)
  {
    this->FillHull(input, output);
    return 1;
  }
  vtkNew<vtkUnstructuredGrid> split;
  this->SplitCells(input, split);
  this->UpdateProgress(0.4);
  switch (this->Mode)
  {
    case REMESH:
      this->Remesh(input, split, output);
      break;
    case DELAUNAY:
      this->Triangulate(input, split, output);
      break;
    default:
      output->ShallowCopy(split);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkTetGenTetrahedralizer::SplitCells(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output)
{
  CellSplitting splitting(input);
  splitting.Run(output);
  this->NumberOfCutCells = splitting.NumberOfCutCells;
  this->NumberOfFailedCells = splitting.NumberOfFailedCells;
  this->NumberOfSkippedCells = splitting.NumberOfSkippedCells;
  this->NumberOfNewPoints = splitting.NumberOfNewPoints;
  if (splitting.NumberOfFailedCells > 0 && this->Mode != DELAUNAY)
  {
    vtkErrorMacro("TetGen could not cut " << splitting.NumberOfFailedCells
                                          << " polyhedra, which are left out; the first is cell "
                                          << splitting.FirstFailedCell << ": "
                                          << splitting.FirstFailure << ".");
  }
}

//------------------------------------------------------------------------------
void vtkTetGenTetrahedralizer::Remesh(
  vtkUnstructuredGrid* input, vtkUnstructuredGrid* split, vtkUnstructuredGrid* output)
{
  const TetGenSurface surface = BoundaryOf(split);
  if (surface.Triangles.empty())
  {
    output->ShallowCopy(split);
    return;
  }
  TetGenSettings settings;
  settings.MaximumRadiusEdgeRatio = this->MaximumRadiusEdgeRatio;
  settings.MaximumVolume = this->MaximumVolume;
  const TetGenMesh mesh = TetGenMesher::Fill(surface, settings);
  if (mesh.Failure.empty())
  {
    this->NumberOfNewPoints =
      static_cast<vtkIdType>(mesh.Points.size() - surface.Points.size()) / 3;
    TakeMesh(mesh, input, split, output);
  }
  else
  {
    this->FellBack = true;
    this->ReportFailure(mesh, "The mesh is cut cell by cell instead.");
    output->ShallowCopy(split);
  }
}

//------------------------------------------------------------------------------
void vtkTetGenTetrahedralizer::Triangulate(
  vtkUnstructuredGrid* input, vtkUnstructuredGrid* split, vtkUnstructuredGrid* output)
{
  // TetGen takes fewer than four points for an error of the program.
  if (split->GetNumberOfPoints() < 4)
  {
    return;
  }
  const TetGenMesh mesh = TetGenMesher::Triangulate(PointsOf(split));
  if (mesh.Failure.empty())
  {
    this->NumberOfNewPoints = 0;
    TakeMesh(mesh, input, split, output);
  }
  else
  {
    this->ReportFailure(mesh, "The output is empty.");
  }
}

//------------------------------------------------------------------------------
void vtkTetGenTetrahedralizer::FillHull(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output)
{
  if (ImaginaryGrid::HasImaginaryCells(input))
  {
    output->ShallowCopy(input);
    return;
  }
  CellComplex complex;
  CellComplexReader::Read(input, complex);
  const HullFillingResult result = HullFilling::Run(complex);
  const ConvexificationResult& filling = result.Convexification;
  this->NumberOfImaginaryCells = filling.Cells.GetNumberOfCells();
  this->NumberOfNewPoints = static_cast<vtkIdType>(filling.Cells.Points.size() / 3);
  ImaginaryGrid::Append(input, filling.Cells, output);
  vtkNew<vtkIdTypeArray> sources;
  sources->SetName("SourceCell");
  sources->SetNumberOfValues(output->GetNumberOfCells());
  const auto last = sources->GetPointer(0) + input->GetNumberOfCells();
  std::iota(sources->GetPointer(0), last, vtkIdType(0));
  std::fill_n(last, this->NumberOfImaginaryCells, vtkIdType(-1));
  output->GetCellData()->AddArray(sources);
  if (!result.Failure.empty())
  {
    TetGenMesh failed;
    failed.Failure = result.Failure;
    failed.IsSelfIntersecting = result.IsSelfIntersecting;
    this->ReportFailure(failed, "No imaginary cells are added.");
  }
  else if (!complex.IsComplex() || filling.VolumeError > LargestVolumeError)
  {
    // Without them a sort finds out by itself that nothing can be proven.
    output->GetFieldData()->RemoveArray("ImaginaryContacts");
    vtkWarningMacro("The mesh is no cell complex, or the imaginary cells miss "
                    << 100.0 * filling.VolumeError
                    << " % of its convex hull. Its order cannot be proven.");
  }
}

//------------------------------------------------------------------------------
void vtkTetGenTetrahedralizer::ReportFailure(const TetGenMesh& mesh, const char* instead)
{
  if (mesh.IsSelfIntersecting)
  {
    vtkWarningMacro("TetGen: " << mesh.Failure
                               << " (cells that overlap, or faces that do not match). " << instead);
  }
  else
  {
    vtkErrorMacro("TetGen: " << mesh.Failure << ". " << instead);
  }
}

//------------------------------------------------------------------------------
void vtkTetGenTetrahedralizer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const modes[] = { "CellByCell", "Remesh", "Delaunay", "FillHull" };
  os << indent << "Mode: " << modes[this->Mode] << "\n";
  os << indent << "MaximumRadiusEdgeRatio: " << this->MaximumRadiusEdgeRatio << "\n";
  os << indent << "MaximumVolume: " << this->MaximumVolume << "\n";
  os << indent << "NumberOfCutCells: " << this->NumberOfCutCells << "\n";
  os << indent << "NumberOfFailedCells: " << this->NumberOfFailedCells << "\n";
  os << indent << "NumberOfSkippedCells: " << this->NumberOfSkippedCells << "\n";
  os << indent << "NumberOfNewPoints: " << this->NumberOfNewPoints << "\n";
  os << indent << "NumberOfImaginaryCells: " << this->NumberOfImaginaryCells << "\n";
  os << indent << "FellBack: " << (this->FellBack ? "Yes" : "No") << "\n";
}
