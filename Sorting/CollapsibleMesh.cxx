#include "CollapsibleMesh.h"

#include <algorithm>

constexpr int CollapsibleMesh::FaceOf[4][3];

//------------------------------------------------------------------------------
CollapsibleMesh::CollapsibleMesh(std::vector<double> points, std::vector<Tetrahedron> tetrahedra)
  : Points(std::move(points))
  , Tetrahedra(std::move(tetrahedra))
  , First(this->Points.size() / 3, -1)
  , Next(4 * this->Tetrahedra.size(), -1)
  , Alive(this->Tetrahedra.size(), 1)
  , Open(4 * this->Tetrahedra.size(), 0)
  , OnBoundary(this->Points.size() / 3, 0)
{
  this->LinkCorners();
  this->FindOpenFaces();
}

//------------------------------------------------------------------------------
void CollapsibleMesh::LinkCorners()
{
  for (int corner = static_cast<int>(this->Next.size()) - 1; corner >= 0; --corner)
  {
    int& first = this->First[this->Tetrahedra[corner / 4][corner % 4]];
    this->Next[corner] = first;
    first = corner;
  }
}

//------------------------------------------------------------------------------
void CollapsibleMesh::FindOpenFaces()
{
  for (int corner = 0; corner < static_cast<int>(this->Open.size()); ++corner)
  {
    if (this->FindAcross(corner) < 0)
    {
      this->Open[corner] = 1;
      for (const int place : FaceOf[corner % 4])
      {
        this->OnBoundary[this->Tetrahedra[corner / 4][place]] = 1;
      }
    }
  }
}

//------------------------------------------------------------------------------
bool CollapsibleMesh::Contains(int tetrahedron, int point) const
{
  const Tetrahedron& t = this->Tetrahedra[tetrahedron];
  return t[0] == point || t[1] == point || t[2] == point || t[3] == point;
}

//------------------------------------------------------------------------------
int CollapsibleMesh::PlaceOf(int tetrahedron, int point) const
{
  const Tetrahedron& t = this->Tetrahedra[tetrahedron];
  return static_cast<int>(std::find(t.begin(), t.end(), point) - t.begin());
}

//------------------------------------------------------------------------------
void CollapsibleMesh::GetStar(int point, std::vector<int>& star)
{
  star.clear();
  for (int* link = &this->First[point]; *link >= 0;)
  {
    const int corner = *link;
    if (this->Alive[corner / 4])
    {
      star.push_back(corner);
      link = &this->Next[corner];
    }
    else
    {
      *link = this->Next[corner];
    }
  }
}

//------------------------------------------------------------------------------
int CollapsibleMesh::FindAcross(int corner)
{
  const int own = corner / 4;
  const Tetrahedron& t = this->Tetrahedra[own];
  const int* face = FaceOf[corner % 4];
  for (int other = this->First[t[face[0]]]; other >= 0; other = this->Next[other])
  {
    const int n = other / 4;
    if (n != own && this->Alive[n] && this->Contains(n, t[face[1]]) &&
        this->Contains(n, t[face[2]]))
    {
      const Tetrahedron& o = this->Tetrahedra[n];
      const auto isApart = [&](int point)
      { return point != t[face[0]] && point != t[face[1]] && point != t[face[2]]; };
      return 4 * n + static_cast<int>(std::find_if(o.begin(), o.end(), isApart) - o.begin());
    }
  }
  return -1;
}

//------------------------------------------------------------------------------
void CollapsibleMesh::MoveFace(int from, int to)
{
  if (this->Open[from] && to >= 0)
  {
    this->Open[to] = 1;
    this->Moved.emplace_back(from, to);
  }
}

//------------------------------------------------------------------------------
const std::vector<std::pair<int, int>>& CollapsibleMesh::Collapse(
  int from, int to, const std::vector<int>& star)
{
  // A tetrahedron of both points becomes the face that two of its faces fall together to.
  this->Moved.clear();
  for (const int corner : star)
  {
    const int t = corner / 4;
    if (this->Contains(t, to))
    {
      const int withFrom = 4 * t + this->PlaceOf(t, to);
      this->MoveFace(withFrom, this->FindAcross(corner));
      this->MoveFace(corner, this->FindAcross(withFrom));
    }
  }
  for (const int corner : star)
  {
    const int t = corner / 4;
    if (this->Contains(t, to))
    {
      this->Alive[t] = 0;
    }
    else
    {
      this->Tetrahedra[t][corner % 4] = to;
      this->Next[corner] = this->First[to];
      this->First[to] = corner;
    }
  }
  this->First[from] = -1;
  return this->Moved;
}
