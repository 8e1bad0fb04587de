#include "CellFaces.h"

#include "ExactOrientation.h"
#include "TetrahedralSplit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace
{
// The polygon from its smallest id on, without ids that repeat.
void Tidy(std::vector<int>& face)
{
  face.erase(std::unique(face.begin(), face.end()), face.end());
  while (face.size() > 1 && face.front() == face.back())
  {
    face.pop_back();
  }
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
}
}

//------------------------------------------------------------------------------
void CellFaces::AddTriangle(int cell, const int corners[3], int side, bool isPart, int turn)
{
  FaceTriangle triangle{ { corners[0], corners[1], corners[2] }, cell,
    static_cast<signed char>(side), isPart, static_cast<signed char>(turn) };
  std::sort(triangle.Points, triangle.Points + 3);
  this->Triangles.push_back(triangle);
}

//------------------------------------------------------------------------------
void CellFaces::AddTetrahedron(int cell, const int corners[4])
{
  int c[4];
  std::copy_n(corners, 4, c);
  std::sort(c, c + 4);
  // One determinant tells all four sides: exchanging two points turns its sign.
  const int side = c[0] == c[1] || c[1] == c[2] || c[2] == c[3]
                     ? 0
                     : ExactOrientation::SideOfPoint(
                         this->At(c[0]), this->At(c[1]), this->At(c[2]), this->At(c[3]));
  for (int left = 0; left < 4; ++left)
  {
    const int face[3] = { c[left == 0 ? 1 : 0], c[left < 2 ? 2 : 1], c[left < 3 ? 3 : 2] };
    if (face[0] != face[1] && face[1] != face[2])
    {
      this->AddTriangle(cell, face, left % 2 == 1 ? side : -side, false, 1);
    }
  }
}

//------------------------------------------------------------------------------
void CellFaces::AddFace(int cell, std::vector<int> face, const std::vector<int>& cellPoints)
{
  Tidy(face);
  for (const FaceTriangles::Triangle& t : this->CutFace(face))
  {
    int corners[3] = { face[t[0]], face[t[1]], face[t[2]] };
    const int inversions =
      (corners[0] > corners[1]) + (corners[0] > corners[2]) + (corners[1] > corners[2]);
    std::sort(corners, corners + 3);
    this->AddTriangle(cell, corners, this->FindSide(corners, face, cellPoints), face.size() > 3,
      inversions % 2 == 0 ? 1 : -1);
  }
}

//------------------------------------------------------------------------------
// By places in the face.
std::vector<FaceTriangles::Triangle> CellFaces::CutFace(const std::vector<int>& face) const
{
  if (face.size() <= 3)
  {
    return face.size() < 3 ? std::vector<FaceTriangles::Triangle>{}
                           : std::vector<FaceTriangles::Triangle>{ { 0, 1, 2 } };
  }
  const int offsets[2] = { 0, static_cast<int>(face.size()) };
  std::vector<int> places(face.size());
  std::iota(places.begin(), places.end(), 0);
  const std::vector<vtkIdType> ids(face.begin(), face.end());
  std::vector<std::array<double, 3>> points(face.size());
  for (std::size_t i = 0; i < face.size(); ++i)
  {
    std::copy_n(this->At(face[i]), 3, points[i].data());
  }
  return FaceTriangles({ offsets[1], 1, offsets, places.data() }, ids.data(),
    reinterpret_cast<const double(*)[3]>(points.data()))
    .Get();
}

//------------------------------------------------------------------------------
int CellFaces::FindSide(
  const int corners[3], const std::vector<int>& face, const std::vector<int>& cellPoints) const
{
  const double *a = this->At(corners[0]), *b = this->At(corners[1]), *c = this->At(corners[2]);
  // The cell's corner that is farthest from the face decides: on a warped face others mislead.
  double largest = -1.0;
  int side = 0;
  for (const int point : cellPoints)
  {
    if (std::find(face.begin(), face.end(), point) == face.end())
    {
      const double height = std::abs(TetrahedralSplit::SixVolumes(a, b, c, this->At(point)));
      if (height > largest)
      {
        const int exact = ExactOrientation::SideOfPoint(a, b, c, this->At(point));
        side = exact != 0 ? exact : side;
        largest = exact != 0 ? height : largest;
      }
    }
  }
  return side;
}

//------------------------------------------------------------------------------
bool CellFaces::IsWoundAlike(std::size_t first) const
{
  std::map<std::pair<int, int>, int> edges;
  for (std::size_t i = first; i < this->Triangles.size(); ++i)
  {
    const FaceTriangle& t = this->Triangles[i];
    edges[{ t.Points[0], t.Points[1] }] += t.Turn;
    edges[{ t.Points[1], t.Points[2] }] += t.Turn;
    edges[{ t.Points[0], t.Points[2] }] -= t.Turn;
  }
  return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

//------------------------------------------------------------------------------
void CellFaces::SettleSides(std::size_t first)
{
  int agreeing = 0, disagreeing = 0;
  for (std::size_t i = first; i < this->Triangles.size(); ++i)
  {
    const FaceTriangle& t = this->Triangles[i];
    agreeing += t.Side == t.Turn ? 1 : 0;
    disagreeing += t.Side == -t.Turn ? 1 : 0;
  }
  if (agreeing == 0 || disagreeing == 0 || !this->IsWoundAlike(first))
  {
    return;
  }
  double volume = 0.0;
  const double* origin = this->At(this->Triangles[first].Points[0]);
  for (std::size_t i = first; i < this->Triangles.size(); ++i)
  {
    const FaceTriangle& t = this->Triangles[i];
    volume += t.Turn * TetrahedralSplit::SixVolumes(this->At(t.Points[0]), this->At(t.Points[1]),
                         this->At(t.Points[2]), origin);
  }
  for (std::size_t i = first; i < this->Triangles.size() && volume != 0.0; ++i)
  {
    FaceTriangle& t = this->Triangles[i];
    t.Side = t.Side == 0 ? t.Side : static_cast<signed char>(volume > 0.0 ? t.Turn : -t.Turn);
  }
}
