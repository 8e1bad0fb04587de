// NASA's Blunt Fin: 40x32x32 points, of which 39 lie on others. Needs CELLPROJECTION_DATA.
#include "ConvexCellsTesting.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiBlockPLOT3DReader.h"
#include "vtkPointData.h"

#include <algorithm>
#include <fstream>
#include <string>

namespace
{
using namespace ConvexCellsTesting;
constexpr int Skipped = 125;

vtkSmartPointer<vtkUnstructuredGrid> Read(const std::string& folder)
{
  vtkNew<vtkMultiBlockPLOT3DReader> reader;
  reader->SetXYZFileName((folder + "/bluntfinxyz.bin").c_str());
  reader->SetQFileName((folder + "/bluntfinq.bin").c_str());
  reader->SetScalarFunctionNumber(100);
  reader->Update();
  vtkNew<vtkAppendFilter> append;
  append->AddInputData(vtkDataSet::SafeDownCast(reader->GetOutput()->GetBlock(0)));
  append->Update();
  return append->GetOutput();
}

double VolumeOf(vtkUnstructuredGrid* grid)
{
  // Green's theorem over the faces that VTK gives, each cut from its first vertex: another road.
  double total = 0.0;
  for (vtkIdType id = 0; id < grid->GetNumberOfCells(); ++id)
  {
    vtkCell* cell = grid->GetCell(id);
    double volume = 0.0;
    for (int index = 0; index < cell->GetNumberOfFaces(); ++index)
    {
      vtkPoints* p = cell->GetFace(index)->GetPoints();
      Point a, b, c, d;
      p->GetPoint(0, a.data());
      p->GetPoint(1, b.data());
      p->GetPoint(2, c.data());
      p->GetPoint(3, d.data());
      // The mean of both diagonals.
      volume +=
        (Dot(Cross(a, b), c) + Dot(Cross(a, c), d) + Dot(Cross(b, c), d) + Dot(Cross(a, b), d)) /
        12.0;
    }
    total += std::abs(volume);
  }
  return total;
}
}

int TestConvexCellsBluntFin(int, char*[])
{
  const char* folder = std::getenv("CELLPROJECTION_DATA");
  if (!folder || !std::ifstream(folder + std::string("/bluntfinxyz.bin")))
  {
    std::cout << "skipped: CELLPROJECTION_DATA names no folder with bluntfinxyz.bin\n";
    return Skipped;
  }
  auto grid = Read(folder);
  CHECK_EQUAL(grid->GetNumberOfCells(), 37479);
  auto filter = Run(grid, true);
  auto* output = filter->GetOutput();
  CHECK_EQUAL(output->GetNumberOfPoints(), 40921);
  CHECK_EQUAL(filter->GetNumberOfMergedPoints(), 39);
  CHECK_EQUAL(output->GetNumberOfCells() + filter->GetNumberOfDroppedTetrahedra(), 224874);
  CHECK(Near(TotalVolume(output), VolumeOf(grid), 1e-4));
  CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 0);
  CHECK_EQUAL(filter->GetNumberOfDegenerateCells(), 39);
  CHECK(output->GetPointData()->GetArray("Density") != nullptr);
  std::cout << output->GetNumberOfCells() << " tetrahedra, "
            << filter->GetNumberOfDroppedTetrahedra() << " dropped, "
            << filter->GetNumberOfInvertedCells() << " inverted, "
            << filter->GetNumberOfFoldedCells() << " folded\n";
  return Result();
}
