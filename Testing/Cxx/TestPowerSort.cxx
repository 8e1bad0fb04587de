// Delaunay meshes are ordered without a misordered face, from everywhere, and no other mesh is
// taken for one.

#include "CellComplex.h"
#include "CellComplexReader.h"
#include "SortMeshes.h"
#include "SortTesting.h"
#include "TangentialSort.h"
#include "TestMeshes.h"
#include "TestScene.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPowerVisibilitySort.h"

namespace
{
// Distance of the eye from the plane of a contact, or the sine of its angle with it.
double DistanceOf(
  const CellComplex& complex, const CellComplex::Contact& contact, const double eye[4])
{
  const double* p[3];
  double u[3], v[3], normal[3], toEye[3];
  for (int i = 0; i < 3; ++i)
  {
    p[i] = complex.Points.data() + 3 * contact.Points[i];
  }
  vtkMath::Subtract(p[1], p[0], u);
  vtkMath::Subtract(p[2], p[0], v);
  vtkMath::Cross(u, v, normal);
  vtkMath::Normalize(normal);
  for (int axis = 0; axis < 3; ++axis)
  {
    toEye[axis] = eye[axis] - (eye[3] == 0.0 ? 0.0 : p[0][axis]);
  }
  return vtkMath::Dot(normal, toEye);
}

// Faces out of order whose plane the eye is clearly off.
int CountMisordered(const CellComplex& complex, const std::vector<vtkIdType>& order,
  const double eye[4], double close)
{
  std::vector<vtkIdType> rank(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    rank[order[i]] = static_cast<vtkIdType>(i);
  }
  int misordered = 0;
  for (const CellComplex::Contact& contact : complex.Contacts)
  {
    const double distance = DistanceOf(complex, contact, eye);
    const bool firstIsNearer = rank[contact.Cells[0]] > rank[contact.Cells[1]];
    misordered += std::abs(distance) > close && firstIsNearer != (distance > 0.0) ? 1 : 0;
  }
  return misordered;
}

// Eyes that tests put into a plane or a corner are beside it by rounding, and so are the keys.
bool IsOffAllPlanes(const SortTesting::Eye& eye)
{
  return eye.Name != "onPlane" && eye.Name != "atCorner" && eye.Name != "near";
}

void CheckDelaunay(TestChecks& checks, vtkUnstructuredGrid* grid, const std::string& name)
{
  vtkNew<vtkPowerVisibilitySort> sort;
  CellComplex complex;
  CellComplexReader::Read(grid, complex);
  for (SortTesting::Eye& eye : SortTesting::Eyes(grid))
  {
    const auto order = SortTesting::OrderOf(sort, grid, eye);
    CHECK(SortTesting::IsPermutation(order, grid->GetNumberOfCells()));
    const double close = 1e-12 * (eye.Position[3] == 0.0 ? 1.0 : grid->GetLength());
    const int clear = CountMisordered(complex, order, eye.Position, close);
    const vtkIdType all = sort->GetNumberOfMisorderedFaces();
    checks.Check(clear == 0 && (all == 0 || !IsOffAllPlanes(eye)), (name + ", " + eye.Name).c_str(),
      __LINE__, std::to_string(all) + " faces misordered, clearly " + std::to_string(clear));
  }
  CHECK_AT_MOST(sort->GetNumberOfIrregularFaces(), 0);
  CHECK_AT_MOST(sort->GetNumberOfCycles(), 0);
}

// The slow reference: the spheres themselves, in perspective.
void CheckAgainstReference(TestChecks& checks)
{
  auto grid = TestMeshes::Delaunay(500);
  vtkNew<vtkPowerVisibilitySort> sort;
  vtkNew<TangentialSort> reference;
  int eyes = 0;
  for (SortTesting::Eye& eye : SortTesting::FewEyes(grid))
  {
    if (eye.Position[3] != 0.0)
    {
      ++eyes;
      CHECK(SortTesting::OrderOf(sort, grid, eye) == SortTesting::OrderOf(reference, grid, eye));
    }
  }
  CHECK(eyes >= 2);
}

// Sorted by another mesh's proof, it would be wrong: ties within each cube, cells of no sphere.
void CheckOthers(TestChecks& checks)
{
  vtkNew<vtkPowerVisibilitySort> sort;
  auto lattice = SortMeshes::Kuhn(SortMeshes::Lattice(6));
  sort->SetInput(lattice);
  // Each cube has 6 faces inside, all tied; those between cubes whose diagonals agree are not.
  CHECK(sort->GetNumberOfIrregularFaces() >= 6 * 6 * 6 * 6);
  CHECK(!sort->IsExact());
  auto jittered = SortMeshes::Kuhn(SortMeshes::JitteredLattice(6, 0.2));
  sort->SetInput(jittered);
  CHECK(sort->GetNumberOfIrregularFaces() > 100);
  int wrong = 0;
  for (SortTesting::Eye& eye : SortTesting::FewEyes(jittered))
  {
    CHECK(SortTesting::IsPermutation(
      SortTesting::OrderOf(sort, jittered, eye), jittered->GetNumberOfCells()));
    wrong += sort->GetNumberOfMisorderedFaces() > 0 ? 1 : 0;
    CHECK(!sort->IsOrderProven());
  }
  CHECK(wrong > 0);
}

// Boxes have spheres, and keep clear of their neighbours'; a hole in them is no longer convex.
void CheckBoxes(TestChecks& checks)
{
  vtkNew<vtkPowerVisibilitySort> sort;
  auto boxes = SortMeshes::Scaled(SortMeshes::Lattice(5), 1.0, 3.0, 0.25);
  CheckDelaunay(checks, boxes, "boxes");
  sort->SetInput(boxes);
  CHECK(sort->IsExact());
  for (SortTesting::Eye& eye : SortTesting::FewEyes(boxes))
  {
    SortTesting::OrderOf(sort, boxes, eye);
    CHECK(sort->IsOrderProven());
  }
  auto holed = SortMeshes::Select(boxes, [](vtkIdType cell) { return cell != 62; });
  SortTesting::Eye eye = SortTesting::EyeUp(holed, false);
  SortTesting::OrderOf(sort, holed, eye);
  CHECK_AT_MOST(sort->GetNumberOfIrregularFaces(), 0);
  CHECK(!sort->IsExact() && !sort->IsOrderProven());
}

// New scalars keep what is known, new points do not.
void CheckChanges(TestChecks& checks)
{
  auto grid = SortMeshes::Lattice(3);
  SortMeshes::AddScalar(grid);
  vtkNew<vtkPowerVisibilitySort> sort;
  CHECK(sort->GetNumberOfIrregularFaces() == 0 && !sort->IsExact());
  sort->SetInput(grid);
  CHECK(sort->IsExact());
  grid->GetPointData()->GetArray(0)->SetTuple1(0, 5.0);
  grid->GetPointData()->GetArray(0)->Modified();
  CHECK(sort->IsExact());
  double p[3];
  grid->GetPoint(21, p);
  grid->GetPoints()->SetPoint(21, p[0] + 0.02, p[1] + 0.01, p[2] - 0.03);
  grid->GetPoints()->Modified();
  CHECK(sort->GetNumberOfIrregularFaces() > 0 && !sort->IsExact());
  sort->ConvexifyOff();
  CHECK(!sort->IsOrderProven());
}
}

int TestPowerSort(int, char*[])
{
  TestChecks checks;
  auto delaunay = TestMeshes::Delaunay(2000);
  CheckDelaunay(checks, delaunay, "Delaunay");
  CheckDelaunay(checks, SortMeshes::Moved(delaunay, 1e7, -1e7, 1e7), "near 1e7");
  CheckDelaunay(checks, SortMeshes::Scaled(delaunay, 1e-7, 1e-7, 1e-7), "near 1e-7");
  CheckAgainstReference(checks);
  CheckOthers(checks);
  CheckBoxes(checks);
  CheckChanges(checks);
  return checks.Result();
}
