#include "BoundaryPatch.h"

#include "NearestPlace.h"

#include <algorithm>
#include <cmath>

namespace
{
// Cosine of how far a triangle may turn.
constexpr double LeastCosine = 0.5;

void NormalOf(const double a[3], const double b[3], const double c[3], double normal[3])
{
  for (int x = 0; x < 3; ++x)
  {
    const int y = (x + 1) % 3, z = (x + 2) % 3;
    normal[x] = (b[y] - a[y]) * (c[z] - a[z]) - (b[z] - a[z]) * (c[y] - a[y]);
  }
}

bool IsTurnedLittle(const double u[3], const double v[3])
{
  const auto dot = [](const double a[3], const double b[3])
  { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  return dot(u, v) > LeastCosine * std::sqrt(dot(u, u) * dot(v, v));
}
}

//------------------------------------------------------------------------------
BoundaryPatch::BoundaryPatch(CollapsibleMesh& mesh, double bound)
  : Mesh(mesh)
  , Bound(bound)
  , Samples(4 * mesh.GetNumberOfTetrahedra())
  , Marks(static_cast<size_t>(mesh.GetNumberOfPoints()), 0)
{
  for (int face = 0; face < 4 * mesh.GetNumberOfTetrahedra(); ++face)
  {
    if (mesh.IsOpen(face))
    {
      double middle[3] = { 0.0, 0.0, 0.0 };
      for (const int place : CollapsibleMesh::FaceOf[face % 4])
      {
        const double* x = mesh.GetPoint(mesh.Get(face / 4)[place]);
        std::transform(x, x + 3, middle, middle, [](double c, double m) { return m + c / 3.0; });
      }
      this->Samples.Put(this->Samples.Add(middle, 0.0), face);
    }
  }
}

//------------------------------------------------------------------------------
bool BoundaryPatch::Take(int point, const std::vector<int>& star)
{
  this->Point = point;
  this->Star = star;
  this->Triangles.clear();
  for (const int corner : star)
  {
    const int t = corner / 4;
    for (int place = 0; place < 4; ++place)
    {
      const int face = 4 * t + place;
      if (face != corner && this->Mesh.IsOpen(face))
      {
        const int* of = CollapsibleMesh::FaceOf[place];
        int turn = 0;
        while (of[turn] != corner % 4)
        {
          ++turn;
        }
        this->Triangles.push_back(
          { face, this->Mesh.Get(t)[of[(turn + 1) % 3]], this->Mesh.Get(t)[of[(turn + 2) % 3]] });
      }
    }
  }
  return this->IsDisk();
}

//------------------------------------------------------------------------------
bool BoundaryPatch::IsDisk() const
{
  // Walked from triangle to triangle about the point, all come before the first again.
  if (this->Triangles.empty())
  {
    return false;
  }
  const int start = this->Triangles.front().A;
  int at = start;
  size_t steps = 0;
  do
  {
    const auto isNext = [at](const Triangle& triangle) { return triangle.A == at; };
    if (std::count_if(this->Triangles.begin(), this->Triangles.end(), isNext) != 1)
    {
      return false;
    }
    at = std::find_if(this->Triangles.begin(), this->Triangles.end(), isNext)->B;
    ++steps;
  } while (at != start && steps <= this->Triangles.size());
  return steps == this->Triangles.size();
}

//------------------------------------------------------------------------------
bool BoundaryPatch::FindWings(int to, int wings[2]) const
{
  int count = 0;
  for (const Triangle& triangle : this->Triangles)
  {
    if (triangle.A == to || triangle.B == to)
    {
      wings[count++ % 2] = triangle.A == to ? triangle.B : triangle.A;
    }
  }
  return count == 2;
}

//------------------------------------------------------------------------------
bool BoundaryPatch::MayFollow(int to)
{
  int wings[2];
  if (!this->Mesh.IsOnBoundary(to) || !this->FindWings(to, wings))
  {
    return false;
  }
  this->Mesh.GetStar(to, this->OtherStar);
  return this->KeepsEdges(to, wings) && this->KeepsLink(to) && this->KeepsPairs(to);
}

//------------------------------------------------------------------------------
bool BoundaryPatch::KeepsEdges(int to, const int wings[2])
{
  // Boundary edges of `to` may lead to no other point of the patch than to the wings.
  ++this->Mark;
  for (const int corner : this->OtherStar)
  {
    const int t = corner / 4;
    for (int place = 0; place < 4; ++place)
    {
      if (4 * t + place == corner || !this->Mesh.IsOpen(4 * t + place))
      {
        continue;
      }
      int found = 0;
      for (const int other : CollapsibleMesh::FaceOf[place])
      {
        const int point = this->Mesh.Get(t)[other];
        this->Marks[point] = this->Mark;
        found += point == wings[0] || point == wings[1];
      }
      if (found == 2)
      {
        return false; // it would lie on the triangle that the patch becomes
      }
    }
  }
  return std::all_of(this->Triangles.begin(), this->Triangles.end(),
    [&](const Triangle& triangle)
    {
      return triangle.A == to || triangle.A == wings[0] || triangle.A == wings[1] ||
             this->Marks[triangle.A] != this->Mark;
    });
}

//------------------------------------------------------------------------------
bool BoundaryPatch::KeepsLink(int to)
{
  // Points next to both must be of a tetrahedron of both.
  ++this->Mark;
  for (const int corner : this->OtherStar)
  {
    for (const int point : this->Mesh.Get(corner / 4))
    {
      this->Marks[point] = this->Mark;
    }
  }
  ++this->Mark;
  for (const int corner : this->Star)
  {
    const int t = corner / 4;
    if (this->Mesh.Contains(t, to))
    {
      for (const int point : this->Mesh.Get(t))
      {
        this->Marks[point] = this->Mark;
      }
    }
  }
  for (const int corner : this->Star)
  {
    for (const int point : this->Mesh.Get(corner / 4))
    {
      if (this->Marks[point] == this->Mark - 1)
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool BoundaryPatch::KeepsPairs(int to) const
{
  // The same for edges: of two points next to both that a tetrahedron of either has.
  const auto hasPair = [this](const std::vector<int>& star, int a, int b, int with, int without)
  {
    return std::any_of(star.begin(), star.end(),
      [&](int corner)
      {
        const int t = corner / 4;
        return this->Mesh.Contains(t, a) && this->Mesh.Contains(t, b) &&
               (with < 0 || this->Mesh.Contains(t, with)) &&
               (without < 0 || !this->Mesh.Contains(t, without));
      });
  };
  for (const int corner : this->Star)
  {
    if (this->Mesh.Contains(corner / 4, to))
    {
      continue;
    }
    const int* base = CollapsibleMesh::FaceOf[corner % 4];
    for (int i = 0; i < 3; ++i)
    {
      const int a = this->Mesh.Get(corner / 4)[base[i]];
      const int b = this->Mesh.Get(corner / 4)[base[(i + 1) % 3]];
      if (this->Marks[a] == this->Mark && this->Marks[b] == this->Mark &&
          hasPair(this->OtherStar, a, b, -1, this->Point) && !hasPair(this->Star, a, b, to, -1))
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool BoundaryPatch::AddFollower(const Triangle& triangle, int to)
{
  const int t = triangle.Face / 4;
  Triangle follower = triangle;
  if (this->Mesh.Contains(t, to))
  {
    // The tetrahedron goes, and its other face becomes this one.
    follower.Face = this->Mesh.FindAcross(4 * t + this->Mesh.PlaceOf(t, this->Point));
  }
  const double *a = this->Mesh.GetPoint(triangle.A), *b = this->Mesh.GetPoint(triangle.B);
  double before[3], after[3];
  NormalOf(this->Mesh.GetPoint(this->Point), a, b, before);
  NormalOf(this->Mesh.GetPoint(to), a, b, after);
  this->Followers.push_back(follower);
  return follower.Face >= 0 && IsTurnedLittle(before, after);
}

//------------------------------------------------------------------------------
bool BoundaryPatch::StaysNear(int to)
{
  this->Followers.clear();
  this->Places.clear();
  for (const Triangle& triangle : this->Triangles)
  {
    if (triangle.A != to && triangle.B != to && !this->AddFollower(triangle, to))
    {
      return false;
    }
  }
  const int corner = this->Samples.Add(this->Mesh.GetPoint(this->Point), 0.0);
  this->To = to;
  bool isNear = this->Place(corner);
  for (const Triangle& triangle : this->Triangles)
  {
    for (int s = this->Samples.Begin(triangle.Face); s >= 0 && isNear; s = this->Samples.Next(s))
    {
      isNear = this->Place(s);
    }
  }
  if (!isNear)
  {
    this->Samples.RemoveLast();
  }
  return isNear;
}

//------------------------------------------------------------------------------
bool BoundaryPatch::Place(int sample)
{
  double least = this->Bound * this->Bound;
  int nearest = -1;
  const double* to = this->Mesh.GetPoint(this->To);
  for (size_t i = 0; i < this->Followers.size(); ++i)
  {
    const double square = NearestPlace::SquareDistance(this->Samples.GetPoint(sample), to,
      this->Mesh.GetPoint(this->Followers[i].A), this->Mesh.GetPoint(this->Followers[i].B));
    if (square <= least)
    {
      least = square;
      nearest = static_cast<int>(i);
    }
  }
  this->Places.emplace_back(sample, nearest);
  return nearest >= 0;
}

//------------------------------------------------------------------------------
int BoundaryPatch::FindNearest(const double x[3], int corners[4], double weights[4]) const
{
  double least = -1.0;
  int nearest = -1;
  const double* to = this->Mesh.GetPoint(this->To);
  for (const Triangle& follower : this->Followers)
  {
    const double square = NearestPlace::SquareDistance(
      x, to, this->Mesh.GetPoint(follower.A), this->Mesh.GetPoint(follower.B));
    if (least < 0.0 || square < least)
    {
      least = square;
      nearest = follower.Face / 4;
    }
  }
  const CollapsibleMesh::Tetrahedron& t = this->Mesh.Get(nearest);
  std::replace_copy(t.begin(), t.end(), corners, this->Point, this->To);
  const double* places[4];
  std::transform(
    corners, corners + 4, places, [this](int corner) { return this->Mesh.GetPoint(corner); });
  NearestPlace::FindOnTetrahedron(x, places, weights);
  return nearest;
}

//------------------------------------------------------------------------------
void BoundaryPatch::Forget()
{
  this->Samples.RemoveLast();
}

//------------------------------------------------------------------------------
void BoundaryPatch::Move(const std::vector<std::pair<int, int>>& faces)
{
  for (const std::pair<int, int>& face : faces)
  {
    for (int s = this->Samples.Begin(face.first), next; s >= 0; s = next)
    {
      next = this->Samples.Next(s);
      this->Samples.Put(s, face.second);
    }
    this->Samples.Clear(face.first);
  }
}

//------------------------------------------------------------------------------
void BoundaryPatch::Follow()
{
  for (const Triangle& triangle : this->Triangles)
  {
    this->Samples.Clear(triangle.Face);
  }
  for (const Triangle& follower : this->Followers)
  {
    this->Samples.Clear(follower.Face);
  }
  for (const std::pair<int, int>& place : this->Places)
  {
    this->Samples.Put(place.first, this->Followers[place.second].Face);
  }
}

//------------------------------------------------------------------------------
double BoundaryPatch::FindLargestDistance() const
{
  double largest = 0.0;
  for (int face = 0; face < 4 * this->Mesh.GetNumberOfTetrahedra(); ++face)
  {
    if (this->Mesh.IsAlive(face / 4) && this->Mesh.IsOpen(face))
    {
      const CollapsibleMesh::Tetrahedron& t = this->Mesh.Get(face / 4);
      const int* of = CollapsibleMesh::FaceOf[face % 4];
      for (int s = this->Samples.Begin(face); s >= 0; s = this->Samples.Next(s))
      {
        largest = std::max(largest,
          NearestPlace::SquareDistance(this->Samples.GetPoint(s), this->Mesh.GetPoint(t[of[0]]),
            this->Mesh.GetPoint(t[of[1]]), this->Mesh.GetPoint(t[of[2]])));
      }
    }
  }
  return std::sqrt(largest);
}
