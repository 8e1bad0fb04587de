#include "SortTesting.h"

#include "vtkCamera.h"
#include "vtkCell.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVisibilitySort.h"

#include <algorithm>

namespace
{
using SortTesting::Eye;

struct Frame
{
  double Middle[3];
  double Size;

  explicit Frame(vtkUnstructuredGrid* grid)
  {
    double bounds[6];
    grid->GetBounds(bounds);
    grid->GetCenter(this->Middle);
    this->Size = std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  }

  Eye At(const std::string& name, double x, double y, double z) const
  {
    const double along[3] = { x, y, z };
    Eye eye = { name, { 0.0, 0.0, 0.0, 1.0 } };
    for (int i = 0; i < 3; ++i)
    {
      eye.Position[i] = this->Middle[i] + along[i] * this->Size;
    }
    return eye;
  }
};

Eye Direction(const std::string& name, double x, double y, double z)
{
  Eye eye = { name, { x, y, z, 0.0 } };
  vtkMath::Normalize(eye.Position);
  return eye;
}

Eye Point(const std::string& name, const double p[3])
{
  return { name, { p[0], p[1], p[2], 1.0 } };
}

// Exactly on a face's plane where coordinates are short binary numbers, else within rounding.
Eye OnPlane(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkPoints* face = grid->GetCell(cell)->GetFace(0)->GetPoints();
  double p[3], a[3], b[3];
  face->GetPoint(0, a);
  face->GetPoint(1, b);
  face->GetPoint(2, p);
  for (int i = 0; i < 3; ++i)
  {
    p[i] += 8.0 * (b[i] - a[i]) + 4.0 * (p[i] - a[i]);
  }
  return Point("onPlane", p);
}

void AddInner(vtkUnstructuredGrid* grid, std::vector<Eye>& eyes)
{
  const vtkIdType cell = grid->GetNumberOfCells() / 3;
  double p[3] = { 0.0, 0.0, 0.0 }, corner[3];
  vtkPoints* points = grid->GetCell(cell)->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->GetPoint(i, corner);
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] += corner[axis] / points->GetNumberOfPoints();
    }
  }
  eyes.push_back(Point("inCell", p));
  eyes.push_back(Point("atCorner", corner));
  eyes.push_back(OnPlane(grid, cell));
}
}

//------------------------------------------------------------------------------
Eye SortTesting::EyeUp(vtkUnstructuredGrid* grid, bool parallel)
{
  return parallel ? Direction("up, parallel", 0, 0, 1) : Frame(grid).At("up", 0, 0, 8);
}

//------------------------------------------------------------------------------
std::vector<Eye> SortTesting::FewEyes(vtkUnstructuredGrid* grid)
{
  const Frame frame(grid);
  return { frame.At("oblique", 1.1, 0.7, 1.9), frame.At("opposite", -1.3, 0.2, -0.8),
    frame.At("within", 0.03, -0.04, 0.02), Direction("parallel", 0.3, -0.5, 0.8) };
}

//------------------------------------------------------------------------------
std::vector<Eye> SortTesting::Eyes(vtkUnstructuredGrid* grid)
{
  const Frame frame(grid);
  std::vector<Eye> eyes = FewEyes(grid);
  eyes.push_back(frame.At("alongX", 3, 0, 0));
  eyes.push_back(frame.At("alongY", 0, -2, 0));
  eyes.push_back(frame.At("diagonal", 2, 2, 2));
  eyes.push_back(frame.At("middle", 0, 0, 0));
  eyes.push_back(frame.At("near", 0.1, 0.52, 0.2));
  eyes.push_back(EyeUp(grid, false));
  eyes.push_back(EyeUp(grid, true));
  eyes.push_back(Direction("alongX, parallel", -1, 0, 0));
  eyes.push_back(Direction("faceDiagonal, parallel", 1, 1, 0));
  eyes.push_back(Direction("diagonal, parallel", 1, 1, 1));
  AddInner(grid, eyes);
  return eyes;
}

//------------------------------------------------------------------------------
void SortTesting::SetCamera(vtkCamera* camera, vtkUnstructuredGrid* grid, Eye& eye)
{
  const Frame frame(grid);
  double position[3], focus[3];
  for (int i = 0; i < 3; ++i)
  {
    const bool parallel = eye.Position[3] == 0.0;
    position[i] = eye.Position[i];
    // Parallel: about the origin, so that the direction keeps all its digits.
    focus[i] = parallel ? 0.0 : frame.Middle[i];
  }
  if (vtkMath::Distance2BetweenPoints(position, focus) == 0.0)
  {
    focus[2] -= frame.Size;
  }
  camera->SetParallelProjection(eye.Position[3] == 0.0);
  camera->SetPosition(position);
  camera->SetFocalPoint(focus);
  // Up must not lie along the view.
  double normal[3];
  camera->GetViewPlaneNormal(normal);
  camera->SetViewUp(
    std::abs(normal[1]) > 0.9 ? 1.0 : 0.0, std::abs(normal[1]) > 0.9 ? 0.0 : 1.0, 0);
  if (eye.Position[3] == 0.0)
  {
    camera->GetViewPlaneNormal(eye.Position);
  }
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> SortTesting::OrderOf(
  vtkVisibilitySort* sort, vtkUnstructuredGrid* grid, Eye& eye)
{
  vtkNew<vtkCamera> camera;
  SetCamera(camera, grid, eye);
  vtkNew<vtkMatrix4x4> identity;
  sort->SetModelTransform(identity);
  sort->SetInput(grid);
  sort->SetCamera(camera);
  sort->SetDirectionToBackToFront();
  sort->SetMaxCellsReturned(1000);
  sort->InitTraversal();
  std::vector<vtkIdType> order;
  while (vtkIdTypeArray* batch = sort->GetNextCells())
  {
    for (vtkIdType i = 0; i < batch->GetNumberOfTuples(); ++i)
    {
      order.push_back(batch->GetValue(i));
    }
  }
  return order;
}

//------------------------------------------------------------------------------
bool SortTesting::IsPermutation(const std::vector<vtkIdType>& order, vtkIdType count)
{
  std::vector<vtkIdType> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  for (vtkIdType id = 0; id < count; ++id)
  {
    if (id >= static_cast<vtkIdType>(sorted.size()) || sorted[id] != id)
    {
      return false;
    }
  }
  return static_cast<vtkIdType>(sorted.size()) == count;
}
