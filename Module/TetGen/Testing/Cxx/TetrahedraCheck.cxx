#include "TetrahedraCheck.h"

#include "ConvexCellsTesting.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkConvexifyFilter.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <map>

using namespace ConvexCellsTesting;

namespace
{
constexpr int FaceOf[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };

// By sorted corners: how many cells see the triangle turn either way.
using Sides = std::map<std::array<vtkIdType, 3>, std::array<int, 2>>;

Sides FindSides(vtkUnstructuredGrid* grid)
{
  Sides sides;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    for (const auto& face : FaceOf)
    {
      std::array<vtkIdType, 3> corners = { ids->GetId(face[0]), ids->GetId(face[1]),
        ids->GetId(face[2]) };
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      const int side = corners[1] < corners[2] ? 0 : 1;
      std::sort(corners.begin(), corners.end());
      ++sides[corners][side];
    }
  }
  return sides;
}

void CountMessage(vtkObject*, unsigned long event, void* data, void*)
{
  auto* messages = static_cast<TetrahedraCheck::Messages*>(data);
  ++(event == vtkCommand::ErrorEvent ? messages->Errors : messages->Warnings);
}
}

namespace TetrahedraCheck
{
//------------------------------------------------------------------------------
Faces CountFaces(vtkUnstructuredGrid* tetrahedra)
{
  Faces faces;
  for (const auto& entry : FindSides(tetrahedra))
  {
    const int both = entry.second[0] + entry.second[1];
    if (both == 1)
    {
      Point p[3];
      for (int i = 0; i < 3; ++i)
      {
        p[i] = PointOf(tetrahedra, entry.first[i]);
      }
      ++faces.Boundary;
      faces.BoundaryArea += vtkTriangle::TriangleArea(p[0].data(), p[1].data(), p[2].data());
    }
    else
    {
      ++(both == 2 && entry.second[0] == 1 ? faces.Inner : faces.Wrong);
    }
  }
  return faces;
}

//------------------------------------------------------------------------------
std::vector<std::vector<double>> BoundaryTriangles(vtkUnstructuredGrid* tetrahedra)
{
  std::vector<std::vector<double>> triangles;
  for (const auto& entry : FindSides(tetrahedra))
  {
    if (entry.second[0] + entry.second[1] == 1)
    {
      std::vector<Point> corners;
      for (const vtkIdType id : entry.first)
      {
        corners.push_back(PointOf(tetrahedra, id));
      }
      std::sort(corners.begin(), corners.end());
      std::vector<double> triangle;
      for (const Point& corner : corners)
      {
        triangle.insert(triangle.end(), corner.begin(), corner.end());
      }
      triangles.push_back(triangle);
    }
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

//------------------------------------------------------------------------------
std::vector<double> VolumesBySource(vtkUnstructuredGrid* tetrahedra, vtkIdType cells)
{
  std::vector<double> volumes(static_cast<size_t>(cells) + 1, 0.0);
  vtkDataArray* sources = tetrahedra->GetCellData()->GetArray("SourceCell");
  for (vtkIdType i = 0; sources && i < tetrahedra->GetNumberOfCells(); ++i)
  {
    const auto source = static_cast<vtkIdType>(sources->GetTuple1(i));
    volumes[source < 0 ? cells : source] += TetrahedronVolume(tetrahedra, i);
  }
  return volumes;
}

//------------------------------------------------------------------------------
double HullVolume(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkConvexifyFilter> cuts;
  cuts->SetInputData(grid);
  cuts->Update();
  return cuts->GetEnclosureVolume();
}

//------------------------------------------------------------------------------
void AddLinear(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("linear");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    const double* x = grid->GetPoint(i);
    array->InsertNextValue(3.0 * x[0] - 2.0 * x[1] + x[2] + 1.0);
  }
  grid->GetPointData()->AddArray(array);
}

//------------------------------------------------------------------------------
double LinearError(vtkUnstructuredGrid* grid)
{
  vtkDataArray* array = grid->GetPointData()->GetArray("linear");
  double error = array ? 0.0 : 1.0;
  for (vtkIdType i = 0; array && i < grid->GetNumberOfPoints(); ++i)
  {
    const double* x = grid->GetPoint(i);
    error = std::max(error, std::abs(array->GetTuple1(i) - (3.0 * x[0] - 2.0 * x[1] + x[2] + 1.0)));
  }
  return error;
}

//------------------------------------------------------------------------------
Messages::Messages(vtkObject* object)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(CountMessage);
  command->SetClientData(this);
  object->AddObserver(vtkCommand::ErrorEvent, command);
  object->AddObserver(vtkCommand::WarningEvent, command);
}
}
