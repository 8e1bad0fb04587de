// The sort as a vtkVisibilitySort: batches, directions, cameras, and what it computes again when.

#include "SortMeshes.h"
#include "SortTesting.h"
#include "TestScene.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMPVOVisibilitySort.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPowerVisibilitySort.h"
#include "vtkSMPTools.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace
{
using Order = std::vector<vtkIdType>;

// What a window in stereo makes of a camera.
class StereoCamera : public vtkCamera
{
public:
  static StereoCamera* New();
  vtkTypeMacro(StereoCamera, vtkCamera);

protected:
  StereoCamera() { this->Stereo = 1; }
};
vtkStandardNewMacro(StereoCamera);

Order Traverse(vtkVisibilitySort* sort)
{
  Order order;
  sort->InitTraversal();
  while (vtkIdTypeArray* batch = sort->GetNextCells())
  {
    const vtkIdType* ids = batch->GetPointer(0);
    order.insert(order.end(), ids, ids + batch->GetNumberOfValues());
    if (batch->GetNumberOfValues() == 0 || batch->GetNumberOfValues() > sort->GetMaxCellsReturned())
    {
      return {};
    }
  }
  return order;
}

// What was in front is behind.
void Turn(vtkPoints* points, const double center[3])
{
  double x[3];
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->GetPoint(i, x);
    points->SetPoint(i, 2.0 * center[0] - x[0], 2.0 * center[1] - x[1], 2.0 * center[2] - x[2]);
  }
}

struct Setting
{
  SortMeshes::Grid Grid = SortMeshes::Kuhn(SortMeshes::JitteredLattice(4, 0.2));
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkMPVOVisibilitySort> Sort;

  Setting()
  {
    this->Camera->SetPosition(7.0, 3.0, 5.0);
    this->Camera->SetFocalPoint(this->Grid->GetCenter());
    this->Sort->SetInput(this->Grid);
    this->Sort->SetCamera(this->Camera);
  }
};

void TestBatchesAndDirections(TestChecks& checks)
{
  Setting at;
  const Order whole = Traverse(at.Sort);
  const vtkIdType cells = at.Grid->GetNumberOfCells();
  CHECK(SortTesting::IsPermutation(whole, cells));
  CHECK(at.Sort->IsOrderProven());
  for (const vtkIdType size : { vtkIdType(1), vtkIdType(7), cells - 1, cells, 10 * cells })
  {
    at.Sort->SetMaxCellsReturned(static_cast<int>(size));
    CHECK(Traverse(at.Sort) == whole);
  }
  at.Sort->SetDirectionToFrontToBack();
  for (const int size : { 7, 1000000 })
  {
    at.Sort->SetMaxCellsReturned(size);
    const Order reversed = Traverse(at.Sort);
    CHECK(Order(reversed.rbegin(), reversed.rend()) == whole);
  }
  at.Sort->SetDirectionToBackToFront();
  CHECK(Traverse(at.Sort) == whole);
  CHECK(at.Sort->GetNumberOfSorts() == 1);
  // A traversal may begin anew before the last one has ended.
  at.Sort->InitTraversal();
  at.Sort->GetNextCells();
  CHECK(Traverse(at.Sort) == whole);
}

// Scalars change nothing, points do, and so does another grid.
void TestCaches(TestChecks& checks)
{
  Setting at;
  const Order before = Traverse(at.Sort);
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetNumberOfValues(at.Grid->GetNumberOfPoints());
  scalars->Fill(1.0);
  at.Grid->GetPointData()->SetScalars(scalars);
  at.Grid->Modified();
  CHECK(Traverse(at.Sort) == before);
  CHECK(at.Sort->GetNumberOfSorts() == 1);

  // Other cells are in front.
  vtkPoints* points = at.Grid->GetPoints();
  Turn(points, at.Grid->GetCenter());
  points->Modified();
  const Order after = Traverse(at.Sort);
  CHECK(at.Sort->GetNumberOfSorts() == 2);
  CHECK(SortTesting::IsPermutation(after, at.Grid->GetNumberOfCells()) && after != before);
  CHECK(at.Sort->IsOrderProven());
  CHECK(at.Sort->GetNumberOfMisorderedFaces() == 0);

  auto small = SortMeshes::Slabs();
  at.Sort->SetInput(small);
  CHECK(SortTesting::IsPermutation(Traverse(at.Sort), small->GetNumberOfCells()));
  at.Sort->SetInput(at.Grid);
  CHECK(SortTesting::IsPermutation(Traverse(at.Sort), at.Grid->GetNumberOfCells()));
  CHECK(at.Sort->IsOrderProven());
}

// An older object in another's place is a change too.
void TestReplacements(TestChecks& checks)
{
  Setting at;
  vtkNew<vtkPoints> turned;
  turned->DeepCopy(at.Grid->GetPoints());
  Turn(turned, at.Grid->GetCenter());
  at.Grid->GetPoints()->GetData()->Modified();
  at.Grid->GetCells()->GetConnectivityArray()->Modified();
  const Order before = Traverse(at.Sort);
  at.Grid->SetPoints(turned);
  CHECK(Traverse(at.Sort) != before);
  CHECK(at.Sort->GetNumberOfSorts() == 2);
  CHECK(at.Sort->IsOrderProven());

  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName("Imaginary");
  marks->SetNumberOfValues(at.Grid->GetNumberOfCells());
  marks->Fill(0);
  marks->SetValue(0, 1);
  at.Grid->GetCellData()->AddArray(marks);
  const Order marked = Traverse(at.Sort);
  CHECK(static_cast<vtkIdType>(marked.size()) == at.Grid->GetNumberOfCells() - 1);
  CHECK(std::find(marked.begin(), marked.end(), 0) == marked.end());
}

// Seen from `eye`, whatever makes the camera look from there.
Order OrderFrom(const SortMeshes::Grid& grid, const std::array<double, 4>& eye)
{
  vtkNew<vtkMPVOVisibilitySort> sort;
  SortTesting::Eye known = { "known", { eye[0], eye[1], eye[2], eye[3] } };
  return SortTesting::OrderOf(sort, grid, known);
}

void TestCameras(TestChecks& checks)
{
  Setting at;
  // A model transform moves the eye the other way.
  vtkNew<vtkTransform> transform;
  transform->Translate(1.0, 2.0, -3.0);
  transform->Scale(2.0, 2.0, 0.5);
  at.Sort->SetModelTransform(transform->GetMatrix());
  std::array<double, 4> eye = { 7.0, 3.0, 5.0, 1.0 };
  at.Sort->GetInverseModelTransform()->MultiplyPoint(eye.data(), eye.data());
  CHECK(Traverse(at.Sort) == OrderFrom(at.Grid, eye));
  vtkNew<vtkMatrix4x4> identity;
  at.Sort->SetModelTransform(identity);

  // Sheared in parallel projection: the rays lean by dx and dy per unit of depth.
  at.Camera->SetParallelProjection(true);
  at.Camera->SetPosition(0.0, 0.0, 20.0);
  at.Camera->SetFocalPoint(0.0, 0.0, 0.0);
  at.Camera->SetViewShear(0.7, -0.4, 0.0);
  const Order sheared = Traverse(at.Sort);
  CHECK(at.Sort->IsOrderProven());
  const double length = std::sqrt(1.0 + 0.7 * 0.7 + 0.4 * 0.4);
  const bool leansOneWay =
    sheared == OrderFrom(at.Grid, { 0.7 / length, -0.4 / length, 1.0 / length, 0.0 });
  const bool leansTheOther =
    sheared == OrderFrom(at.Grid, { -0.7 / length, 0.4 / length, 1.0 / length, 0.0 });
  CHECK(leansOneWay || leansTheOther);
  at.Camera->SetViewShear(0.0, 0.0, 0.0);
  CHECK(Traverse(at.Sort) != sheared);
}

// Eyes of a stereo pair between which a plane of faces lies have orders of their own.
void TestStereo(TestChecks& checks)
{
  Setting at;
  at.Grid = SortMeshes::Lattice(4);
  at.Sort->SetInput(at.Grid);
  double center[3];
  at.Grid->GetCenter(center);
  vtkNew<StereoCamera> camera;
  camera->SetPosition(center[0], center[1], center[2] + 3.0);
  camera->SetFocalPoint(center);
  camera->SetEyeAngle(4.0);
  camera->SetLeftEye(1);
  at.Sort->SetCamera(camera);
  const Order left = Traverse(at.Sort);
  CHECK(at.Sort->IsOrderProven());
  camera->SetLeftEye(0);
  const Order right = Traverse(at.Sort);
  CHECK(at.Sort->IsOrderProven());
  CHECK(SortTesting::IsPermutation(left, at.Grid->GetNumberOfCells()) && left != right);
}

// A mesh with gaps and no fill is not proven; parts of it come by their centres, in both halves.
void TestWithoutFill(TestChecks& checks)
{
  Setting at;
  auto cube = SortMeshes::Lattice(1);
  auto pair = SortMeshes::Join(cube, SortMeshes::Moved(cube, 4.0, 0.0, 0.0));
  auto grid = SortMeshes::Join(pair, SortMeshes::Moved(pair, 8.0, 0.0, 0.0));
  at.Sort->SetInput(grid);
  at.Sort->ConvexifyOff();
  at.Camera->SetFocalPoint(6.0, 0.1, 0.1);
  at.Camera->SetPosition(40.0, 0.1, 0.2);
  CHECK((Traverse(at.Sort) == Order{ 0, 1, 2, 3 }));
  CHECK(!at.Sort->IsOrderProven());
  at.Camera->SetPosition(-40.0, 0.1, 0.2);
  CHECK((Traverse(at.Sort) == Order{ 3, 2, 1, 0 }));
  at.Sort->ConvexifyOn();
  CHECK((Traverse(at.Sort) == Order{ 3, 2, 1, 0 }));
  CHECK(at.Sort->IsOrderProven());
}

// Cells for several blocks and shares.
vtkSmartPointer<vtkUnstructuredGrid> LatticeWithGaps()
{
  auto lattice = SortMeshes::Kuhn(SortMeshes::JitteredLattice(16, 0.2));
  return SortMeshes::Select(lattice, [](vtkIdType cell) { return cell % 97 != 0; });
}

// One thread and all give the same order.
template <class Sort>
void TestThreads(TestChecks& checks, vtkUnstructuredGrid* grid, bool convexify)
{
  for (SortTesting::Eye& eye : SortTesting::FewEyes(grid))
  {
    vtkNew<Sort> all;
    all->SetConvexify(convexify);
    const Order expected = SortTesting::OrderOf(all, grid, eye);
    CHECK(SortTesting::IsPermutation(expected, grid->GetNumberOfCells()));
    vtkSMPTools::LocalScope(vtkSMPTools::Config(1),
      [&]
      {
        vtkNew<Sort> one;
        one->SetConvexify(convexify);
        CHECK(SortTesting::OrderOf(one, grid, eye) == expected);
      });
  }
}

void TestNothing(TestChecks& checks)
{
  vtkNew<vtkMPVOVisibilitySort> sort;
  vtkNew<MessageObserver> observer;
  observer->Watch(sort);
  sort->InitTraversal();
  CHECK(sort->GetNextCells() == nullptr);
  CHECK(observer->Count() == 1);
  CHECK(!sort->IsOrderProven());
  auto grid = SortMeshes::Lattice(1);
  sort->SetInput(grid);
  sort->InitTraversal();
  CHECK(sort->GetNextCells() == nullptr);
  CHECK(observer->Count() == 2);
}
}

int TestMPVOSort(int, char*[])
{
  TestChecks checks;
  TestBatchesAndDirections(checks);
  TestCaches(checks);
  TestReplacements(checks);
  TestCameras(checks);
  TestStereo(checks);
  TestWithoutFill(checks);
  TestThreads<vtkMPVOVisibilitySort>(checks, LatticeWithGaps(), true);
  TestThreads<vtkMPVOVisibilitySort>(checks, LatticeWithGaps(), false);
  TestThreads<vtkPowerVisibilitySort>(checks, LatticeWithGaps(), false);
  TestThreads<vtkMPVOVisibilitySort>(checks, SortMeshes::Make("barsTetrahedra"), true);
  TestNothing(checks);
  return checks.Result();
}
