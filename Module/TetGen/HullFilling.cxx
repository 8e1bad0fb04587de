#include "HullFilling.h"

#include "ConvexHull.h"
#include "TetGenMesher.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace
{
// Of the volume of a hull that the mesh fills.
constexpr double Rounding = 1e-14;

constexpr int FaceOf[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };

// A face as its cell sees it: corners ascend; Above says that the cell lies on the side to which
// the triangle's normal points.
struct Face
{
  std::array<int, 3> Corners;
  bool Above;
  int Cell;
};

// `corners` turn counter-clockwise seen from outside of the cell.
Face MakeFace(int a, int b, int c, int cell)
{
  Face face{ { { a, b, c } }, false, cell };
  const auto order = [&face](int i, int j)
  {
    if (face.Corners[j] < face.Corners[i])
    {
      std::swap(face.Corners[i], face.Corners[j]);
      face.Above = !face.Above;
    }
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return face;
}

// Of a surface whose triangles turn counter-clockwise seen from outside.
class SurfaceVolume
{
public:
  explicit SurfaceVolume(const std::vector<double>& points)
    : Points(points)
  {
  }
  void Add(int a, int b, int c)
  {
    if (this->Origin < 0)
    {
      this->Origin = a;
    }
    double p[3][3];
    const int ids[3] = { a, b, c };
    for (int i = 0; i < 9; ++i)
    {
      p[i / 3][i % 3] = this->Points[3 * static_cast<size_t>(ids[i / 3]) + i % 3] -
                        this->Points[3 * static_cast<size_t>(this->Origin) + i % 3];
    }
    this->Volume += (p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
                      p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
                      p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0])) /
                    6.0;
  }
  double Volume = 0.0;

private:
  const std::vector<double>& Points;
  int Origin = -1;
};

double VolumeOfMesh(const CellComplex& mesh)
{
  SurfaceVolume volume(mesh.Points);
  for (const CellComplex::BoundaryTriangle& triangle : mesh.Boundary)
  {
    volume.Add(triangle.Points[0], triangle.Points[1], triangle.Points[2]);
  }
  return volume.Volume;
}

double VolumeOfHull(const CellComplex& mesh)
{
  std::vector<int> ids;
  for (const CellComplex::BoundaryTriangle& triangle : mesh.Boundary)
  {
    ids.insert(ids.end(), triangle.Points, triangle.Points + 3);
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  SurfaceVolume volume(mesh.Points);
  for (const ConvexHull::Triangle& triangle : ConvexHull::Build(mesh.Points.data(), ids))
  {
    volume.Add(triangle[0], triangle[1], triangle[2]);
  }
  return volume.Volume;
}

TetGenMesh FillHull(const CellComplex& mesh)
{
  TetGenSurface surface;
  surface.Points = mesh.Points;
  for (const CellComplex::BoundaryTriangle& triangle : mesh.Boundary)
  {
    surface.Triangles.push_back({ { triangle.Points[0], triangle.Points[1], triangle.Points[2] } });
  }
  TetGenSettings settings;
  settings.FillsHull = true;
  return TetGenMesher::Fill(surface, settings);
}

double TakeCells(const TetGenMesh& filling, ImaginaryCells& cells)
{
  double total = 0.0;
  cells.AreTetrahedra = true;
  for (const std::array<int, 4>& tetrahedron : filling.Tetrahedra)
  {
    SurfaceVolume volume(filling.Points);
    for (const auto& face : FaceOf)
    {
      const int a = tetrahedron[face[0]], b = tetrahedron[face[1]], c = tetrahedron[face[2]];
      volume.Add(a, b, c);
      cells.FaceCorners.insert(cells.FaceCorners.end(), { a, b, c });
      cells.FaceOffsets.push_back(static_cast<int>(cells.FaceCorners.size()));
    }
    cells.CellOffsets.push_back(static_cast<int>(cells.FaceOffsets.size()) - 1);
    total += volume.Volume;
  }
  return total;
}

// Where two cells share a triangle, one of them imaginary.
std::vector<CellComplex::Contact> FindContacts(
  const CellComplex& mesh, const std::vector<std::array<int, 4>>& tetrahedra)
{
  std::vector<Face> faces;
  for (const CellComplex::BoundaryTriangle& triangle : mesh.Boundary)
  {
    const int* points = triangle.Points;
    faces.push_back(MakeFace(points[0], points[1], points[2], triangle.Cell));
  }
  for (size_t i = 0; i < tetrahedra.size(); ++i)
  {
    const std::array<int, 4>& t = tetrahedra[i];
    for (const auto& face : FaceOf)
    {
      faces.push_back(
        MakeFace(t[face[0]], t[face[1]], t[face[2]], mesh.NumberOfCells + static_cast<int>(i)));
    }
  }
  std::sort(faces.begin(), faces.end(),
    [](const Face& a, const Face& b)
    { return std::tie(a.Corners, a.Cell) < std::tie(b.Corners, b.Cell); });
  std::vector<CellComplex::Contact> contacts;
  for (size_t i = 0; i + 1 < faces.size(); ++i)
  {
    const Face &one = faces[i], &other = faces[i + 1];
    if (one.Corners == other.Corners && one.Above != other.Above)
    {
      CellComplex::Contact contact;
      std::copy(one.Corners.begin(), one.Corners.end(), contact.Points);
      contact.Cells[0] = one.Above ? one.Cell : other.Cell;
      contact.Cells[1] = one.Above ? other.Cell : one.Cell;
      contacts.push_back(contact);
    }
  }
  return contacts;
}
}

namespace HullFilling
{
//------------------------------------------------------------------------------
HullFillingResult Run(const CellComplex& mesh)
{
  HullFillingResult result;
  ConvexificationResult& convexified = result.Convexification;
  convexified.EnclosureVolume = VolumeOfHull(mesh);
  const double missing = convexified.EnclosureVolume - VolumeOfMesh(mesh);
  if (mesh.Boundary.empty() || std::abs(missing) <= Rounding * convexified.EnclosureVolume)
  {
    convexified.IsConvex = true;
    return result;
  }
  const TetGenMesh filling = FillHull(mesh);
  result.Failure = filling.Failure;
  result.IsSelfIntersecting = filling.IsSelfIntersecting;
  if (result.Failure.empty())
  {
    ImaginaryCells& cells = convexified.Cells;
    cells.Points.assign(filling.Points.begin() + static_cast<std::ptrdiff_t>(mesh.Points.size()),
      filling.Points.end());
    convexified.ImaginaryVolume = TakeCells(filling, cells);
    convexified.IsConvex = filling.Tetrahedra.empty();
    cells.Contacts = FindContacts(mesh, filling.Tetrahedra);
    convexified.VolumeError =
      std::abs(convexified.ImaginaryVolume - missing) / convexified.EnclosureVolume;
  }
  return result;
}
}
