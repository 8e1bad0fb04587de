#include "ImaginaryCellAssembly.h"

#include "ExteriorGeometry.h"
#include "vtkMath.h"

#include <algorithm>
#include <set>

namespace
{
// Strips of this many tolerances are no contact.
constexpr double ContactWidth = 8.0;
}

//------------------------------------------------------------------------------
ImaginaryCellAssembly::ImaginaryCellAssembly(const ExteriorGeometry& geometry)
  : Geometry(geometry)
{
}

//------------------------------------------------------------------------------
int ImaginaryCellAssembly::AddCut(int plane)
{
  this->Cuts.push_back({ plane, {}, {} });
  return static_cast<int>(this->Cuts.size()) - 1;
}

//------------------------------------------------------------------------------
void ImaginaryCellAssembly::AddCell(const ExteriorPart& part)
{
  const int cell = this->Geometry.Mesh.NumberOfCells + this->Cells.GetNumberOfCells();
  int faces = 0;
  for (const Facet& facet : FindFacets(this->Geometry, part))
  {
    faces += this->AddFace(facet) ? 1 : 0;
  }
  if (faces < 2)
  {
    this->Cells.FaceOffsets.resize(this->Cells.CellOffsets.back() + 1);
    this->Cells.FaceCorners.resize(this->Cells.FaceOffsets.back());
    return;
  }
  this->Cells.CellOffsets.push_back(static_cast<int>(this->Cells.FaceOffsets.size()) - 1);
  this->AddMeshContacts(part, cell);
  this->AddPieces(part, cell);
}

//------------------------------------------------------------------------------
std::vector<ImaginaryCellAssembly::Facet> ImaginaryCellAssembly::FindFacets(
  const ExteriorGeometry& geometry, const ExteriorPart& part)
{
  std::vector<Facet> facets;
  for (const ExteriorFace& face : part.Faces)
  {
    const auto& normal = geometry.Planes[face.Plane].Normal;
    // Planes of different triangles may be one plane within the tolerance.
    const auto same = std::find_if(facets.begin(), facets.end(),
      [&](const Facet& facet)
      {
        const double along =
          vtkMath::Dot(normal.data(), geometry.Planes[facet.Plane].Normal.data());
        return along * face.Direction * facet.Direction > 0.5 &&
               (facet.Plane == face.Plane ||
                 std::all_of(face.Corners.begin(), face.Corners.end(),
                   [&](int point) { return geometry.SideOf(facet.Plane, point) == 0; }));
      });
    if (same == facets.end())
    {
      facets.push_back({ face.Plane, face.Direction, face.Corners });
      continue;
    }
    same->Points.insert(same->Points.end(), face.Corners.begin(), face.Corners.end());
  }
  return facets;
}

//------------------------------------------------------------------------------
bool ImaginaryCellAssembly::AddFace(const Facet& facet)
{
  std::vector<int> corners = this->Geometry.FindHull(facet.Plane, facet.Points);
  if (corners.size() < 3)
  {
    return false;
  }
  if (facet.Direction < 0)
  {
    std::reverse(corners.begin(), corners.end());
  }
  for (const int corner : corners)
  {
    this->Cells.FaceCorners.push_back(this->TakePoint(corner));
  }
  this->Cells.FaceOffsets.push_back(static_cast<int>(this->Cells.FaceCorners.size()));
  return true;
}

//------------------------------------------------------------------------------
int ImaginaryCellAssembly::TakePoint(int point)
{
  const int meshPoints = static_cast<int>(this->Geometry.Mesh.Points.size() / 3);
  if (point < meshPoints)
  {
    return point;
  }
  const auto inserted =
    this->NewIds.emplace(point, meshPoints + static_cast<int>(this->NewIds.size()));
  if (inserted.second)
  {
    const std::array<double, 3> x = this->Geometry.GetMeshCoordinates(point);
    this->Cells.Points.insert(this->Cells.Points.end(), x.begin(), x.end());
  }
  return inserted.first->second;
}

//------------------------------------------------------------------------------
void ImaginaryCellAssembly::AddMeshContacts(const ExteriorPart& part, int cell)
{
  std::set<int> triangles;
  for (const ExteriorFace& face : part.Faces)
  {
    if (face.Triangle >= 0 && triangles.insert(face.Triangle).second)
    {
      this->AddContact(face.Triangle, cell, this->Geometry.Mesh.Boundary[face.Triangle].Cell);
    }
  }
}

//------------------------------------------------------------------------------
void ImaginaryCellAssembly::AddPieces(const ExteriorPart& part, int cell)
{
  for (const ExteriorFace& face : part.Faces)
  {
    if (face.Cut >= 0)
    {
      Piece piece;
      piece.Cell = cell;
      for (const int corner : face.Corners)
      {
        piece.Outline.push_back(this->Geometry.Project(this->Cuts[face.Cut].Plane, corner));
      }
      if (face.Direction < 0)
      {
        std::reverse(piece.Outline.begin(), piece.Outline.end());
      }
      Cut& cut = this->Cuts[face.Cut];
      (face.Direction > 0 ? cut.Below : cut.Above).push_back(std::move(piece));
    }
  }
}

//------------------------------------------------------------------------------
void ImaginaryCellAssembly::AddContact(int triangle, int above, int below)
{
  // The triangle's normal points out of the mesh; ids ascend, so it may have to turn.
  const auto& points = this->Geometry.Mesh.Boundary[triangle].Points;
  CellComplex::Contact contact{ { points[0], points[1], points[2] }, { above, below } };
  for (const int i : { 0, 1, 0 })
  {
    if (contact.Points[i] > contact.Points[i + 1])
    {
      std::swap(contact.Points[i], contact.Points[i + 1]);
      std::swap(contact.Cells[0], contact.Cells[1]);
    }
  }
  this->Cells.Contacts.push_back(contact);
}

//------------------------------------------------------------------------------
void ImaginaryCellAssembly::FindContacts(const Cut& cut)
{
  const double tolerance = ContactWidth * this->Geometry.Tolerance;
  std::set<std::pair<int, int>> found;
  for (const Piece& below : cut.Below)
  {
    for (const Piece& above : cut.Above)
    {
      if (found.count({ above.Cell, below.Cell }) == 0 &&
          PlanarRegion::Overlap(above.Outline, below.Outline, tolerance))
      {
        found.emplace(above.Cell, below.Cell);
      }
    }
  }
  for (const auto& pair : found)
  {
    this->AddContact(this->Geometry.Planes[cut.Plane].Triangle, pair.first, pair.second);
  }
}

//------------------------------------------------------------------------------
ImaginaryCells ImaginaryCellAssembly::Finish()
{
  for (const Cut& cut : this->Cuts)
  {
    this->FindContacts(cut);
  }
  this->Cuts.clear();
  return std::move(this->Cells);
}
