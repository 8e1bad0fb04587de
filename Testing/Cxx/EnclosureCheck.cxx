// Volumes by the fan of each face from its smallest point id, as the complex takes them.
#include "EnclosureCheck.h"

#include "TestScene.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkConvexifyFilter.h"
#include "vtkDataArray.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace
{
using Point = std::array<double, 3>;

// The corners of each face, from the smallest id on, about the first corner of the cell.
std::vector<std::vector<Point>> FacesOf(vtkUnstructuredGrid* grid, vtkIdType id)
{
  std::vector<std::vector<Point>> faces;
  double origin[3];
  grid->GetCell(id)->GetPoints()->GetPoint(0, origin);
  for (int index = 0; index < grid->GetCell(id)->GetNumberOfFaces(); ++index)
  {
    vtkCell* face = grid->GetCell(id)->GetFace(index);
    std::vector<vtkIdType> ids(face->GetPointIds()->begin(), face->GetPointIds()->end());
    if (face->GetCellType() == VTK_PIXEL)
    {
      std::swap(ids[2], ids[3]);
    }
    std::rotate(ids.begin(), std::min_element(ids.begin(), ids.end()), ids.end());
    faces.emplace_back();
    for (const vtkIdType corner : ids)
    {
      Point p;
      grid->GetPoint(corner, p.data());
      vtkMath::Subtract(p.data(), origin, p.data());
      faces.back().push_back(p);
    }
  }
  return faces;
}

double VolumeOf(const std::vector<std::vector<Point>>& faces)
{
  double volume = 0.0;
  for (const auto& face : faces)
  {
    for (std::size_t i = 2; i < face.size(); ++i)
    {
      volume += vtkMath::Determinant3x3(face[0].data(), face[i - 1].data(), face[i].data()) / 6.0;
    }
  }
  return std::abs(volume);
}

// How far a corner lies outside of a face's plane.
double DentOf(const std::vector<std::vector<Point>>& faces)
{
  double dent = 0.0;
  for (const auto& face : faces)
  {
    Point normal = { { 0.0, 0.0, 0.0 } };
    for (std::size_t i = 2; i < face.size(); ++i)
    {
      Point a, b, n;
      vtkMath::Subtract(face[i - 1].data(), face[0].data(), a.data());
      vtkMath::Subtract(face[i].data(), face[0].data(), b.data());
      vtkMath::Cross(a.data(), b.data(), n.data());
      vtkMath::Add(normal.data(), n.data(), normal.data());
    }
    vtkMath::Normalize(normal.data());
    for (const auto& other : faces)
    {
      for (const Point& p : other)
      {
        Point q;
        vtkMath::Subtract(p.data(), face[0].data(), q.data());
        dent = std::max(dent, vtkMath::Dot(normal.data(), q.data()));
      }
    }
  }
  return dent;
}

// Whether the points of the mesh come first and have not moved.
bool KeepsPoints(vtkConvexifyFilter* filter)
{
  auto* mesh = vtkPointSet::SafeDownCast(filter->GetInputDataObject(0, 0));
  vtkUnstructuredGrid* filled = filter->GetOutput();
  bool keeps = mesh && filled->GetNumberOfPoints() >= mesh->GetNumberOfPoints();
  for (vtkIdType id = 0; keeps && id < mesh->GetNumberOfPoints(); ++id)
  {
    Point before, after;
    mesh->GetPoint(id, before.data());
    filled->GetPoint(id, after.data());
    keeps = before == after;
  }
  return keeps;
}
}

//------------------------------------------------------------------------------
void EnclosureCheck::TestFilled(
  TestChecks& checks, const std::string& name, vtkConvexifyFilter* filter, double largestDent)
{
  vtkUnstructuredGrid* filled = filter->GetOutput();
  vtkDataArray* imaginary = filled->GetCellData()->GetArray("Imaginary");
  const vtkIdType added = filter->GetNumberOfImaginaryCells();
  const vtkIdType cells = filled->GetNumberOfCells() - added;
  double mesh = 0.0, fill = 0.0, dent = 0.0;
  for (vtkIdType id = 0; id < filled->GetNumberOfCells(); ++id)
  {
    const auto faces = FacesOf(filled, id);
    (id < cells ? mesh : fill) += VolumeOf(faces);
    CHECK(!imaginary || (imaginary->GetTuple1(id) != 0.0) == (id >= cells));
    if (id >= cells)
    {
      CHECK(filled->GetCellType(id) == VTK_POLYHEDRON);
      dent = std::max(dent, DentOf(faces));
    }
  }
  CHECK(KeepsPoints(filter));
  const double enclosure = filter->GetEnclosureVolume();
  const double error = std::abs(mesh + fill - enclosure) / enclosure;
  std::cout << name << ": " << added << " imaginary cells, " << filter->GetFacesPerImaginaryCell()
            << " faces each, " << filter->GetSeconds() << " s, volume to " << error << ", dents "
            << dent / filled->GetLength() << "\n";
  checks.Check(error <= 1e-9, name.c_str(), __LINE__, "volumes differ by " + std::to_string(error));
  checks.Check(dent <= largestDent * filled->GetLength(), name.c_str(), __LINE__, "dents");
}
