// Every kind of cell beside every other, straight and curved: what goes out has the volume of what
// came in, and every inner face is matched by exactly one other.
#include "CellZoo.h"
#include "ConvexCellsTesting.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"

namespace
{
using namespace ConvexCellsTesting;

double Linear(const double x[3])
{
  return 0.25 + 0.5 * x[0] - 0.125 * x[1] + 0.75 * x[2];
}

double Square(const double x[3])
{
  const double along = x[0] - 4.0 * std::floor(0.25 * x[0]);
  return 0.25 * along * (4.0 - along) + x[1] * x[1] - x[1] * x[2];
}

struct Lattice
{
  int Size[3];
  std::vector<int> Kinds;
};

// A row has the pairs along x only; a slab of them along y and z, too.
Lattice Row()
{
  const std::vector<int> kinds = CellZoo::AllPairs();
  return { { static_cast<int>(kinds.size()), 1, 1 }, kinds };
}

Lattice Block()
{
  Lattice lattice = { { 4, 4, CellZoo::NumberOfKinds }, {} };
  for (int k = 0; k < lattice.Size[2]; ++k)
  {
    for (int column = 0; column < 16; ++column)
    {
      lattice.Kinds.push_back((k + 7 * column * column) % CellZoo::NumberOfKinds);
    }
  }
  return lattice;
}

void CheckSources(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output)
{
  auto* source = vtkIdTypeArray::SafeDownCast(output->GetCellData()->GetArray("SourceCell"));
  for (vtkIdType cell = 0; CHECK(source) && cell < output->GetNumberOfCells(); ++cell)
  {
    double inputBox[6], box[6];
    input->GetCellBounds(source->GetValue(cell), inputBox);
    output->GetCellBounds(cell, box);
    for (int axis = 0; axis < 3; ++axis)
    {
      CHECK(box[2 * axis] >= inputBox[2 * axis] && box[2 * axis + 1] <= inputBox[2 * axis + 1]);
    }
  }
}

// `tolerance`: 1 where nothing is to be refined.
void CheckLattice(const Lattice& lattice, double (*field)(const double*), double tolerance)
{
  const bool refined = tolerance < 1.0;
  const int* size = lattice.Size;
  auto grid = CellZoo::Make(size, lattice.Kinds, field);
  const double volume = size[0] * size[1] * size[2];
  const double area = 2.0 * (size[0] * size[1] + size[1] * size[2] + size[0] * size[2]);
  for (const bool tetrahedraOnly : { false, true })
  {
    vtkNew<vtkConvexCells> filter;
    filter->SetInputData(grid);
    filter->SetTetrahedraOnly(tetrahedraOnly);
    filter->SetTolerance(tolerance);
    filter->Update();
    vtkUnstructuredGrid* output = filter->GetOutput();
    CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 0);
    CHECK_EQUAL(filter->GetNumberOfDroppedTetrahedra(), 0);
    CHECK(Near(VolumeWithin(output), volume, 1e-10));
    const CellZoo::FaceUses uses = CellZoo::CountFaceUses(output);
    CHECK_EQUAL(uses.More, 0);
    CHECK(Near(uses.AreaOfOnce, area, 1e-10));
    CheckSources(grid, output);
    vtkDataArray* made = output->GetPointData()->GetScalars();
    for (vtkIdType id = 0; CHECK(made) && id < output->GetNumberOfPoints(); ++id)
    {
      const Point x = PointOf(output, id);
      CHECK(field != Linear || std::abs(made->GetTuple1(id) - Linear(x.data())) < 1e-10);
    }
    CHECK(refined == (output->GetNumberOfPoints() > grid->GetNumberOfPoints()));
    CHECK(tetrahedraOnly || refined || output->GetNumberOfCells() == grid->GetNumberOfCells());
  }
}
}

int TestConvexCellsPairs(int, char*[])
{
  CheckLattice(Row(), Linear, 1.0);
  CheckLattice(Row(), Square, 2e-2);
  CheckLattice(Block(), Linear, 1.0);
  CheckLattice(Block(), Square, 2e-3);
  return Result();
}
