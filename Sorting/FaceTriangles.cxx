#include "FaceTriangles.h"

#include "vtkMath.h"

#include <algorithm>

namespace
{
// The square of a cosine.
constexpr double StraightSquared = 1.0 - FaceTriangles::Straight * FaceTriangles::Straight;

// Whether the second edge, of the squared length `v`, goes on where the first one points to.
bool GoesOn(const double first[3], const double second[3], double u, double v)
{
  const double along = vtkMath::Dot(first, second);
  return along > 0.0 && along * along >= StraightSquared * u * v;
}
}

FaceTriangles::FaceTriangles(
  const TetrahedralSplit::Solid& solid, const vtkIdType* ids, const double (*points)[3])
  : NumberOfVertices(solid.NumberOfVertices)
  , Ids(ids)
  , Points(points)
{
  for (int face = 0; face < solid.NumberOfFaces; ++face)
  {
    this->AddFace(solid.Begin(face), solid.End(face));
  }
}

void FaceTriangles::AddFace(const int* begin, const int* end)
{
  const auto isLess = [this](int a, int b) { return this->Ids[a] < this->Ids[b]; };
  const auto isSame = [this](int a, int b) { return this->Ids[a] == this->Ids[b]; };
  Loop loop(begin, end);
  loop.erase(std::unique(loop.begin(), loop.end(), isSame), loop.end());
  while (loop.size() > 1 && isSame(loop.front(), loop.back()))
  {
    loop.pop_back();
  }
  if (loop.size() < 3)
  {
    return;
  }
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end(), isLess), loop.end());
  const bool turned = isLess(loop.back(), loop[1]);
  if (turned)
  {
    std::reverse(loop.begin() + 1, loop.end());
  }
  const std::size_t first = this->Triangles.size();
  this->Cut(loop);
  for (std::size_t i = first; turned && i < this->Triangles.size(); ++i)
  {
    std::swap(this->Triangles[i][1], this->Triangles[i][2]);
  }
}

void FaceTriangles::Cut(const Loop& loop)
{
  const std::size_t count = loop.size();
  const int start = count == 3 ? 0 : this->FindStart(loop);
  const std::size_t half = start < 0 ? this->FindHalf(loop) : 0;
  this->Fans = this->Fans && start == 0;
  if (half > 0)
  {
    this->Cut(Loop(loop.begin(), loop.begin() + half + 1));
    Loop rest(loop.begin() + half, loop.end());
    rest.insert(rest.begin(), loop[0]);
    this->Cut(rest);
    return;
  }
  const std::size_t from = std::max(start, 0);
  for (std::size_t i = 1; i + 1 < count; ++i)
  {
    const Triangle t = { loop[from], loop[(from + i) % count], loop[(from + i + 1) % count] };
    if (!this->Touches({ t[1], t[2], t[2] }, t[0]))
    {
      this->Triangles.push_back(t);
    }
  }
}

// -1 where there is none. Of a face that is not yet cut the first vertex has the smallest id.
int FaceTriangles::FindStart(const Loop& loop) const
{
  if (this->IsStart(loop, 0))
  {
    return 0;
  }
  int best = -1;
  for (std::size_t i = 1; i < loop.size(); ++i)
  {
    const bool isLess = best < 0 || this->Ids[loop[i]] < this->Ids[loop[best]];
    best = isLess && this->IsStart(loop, i) ? static_cast<int>(i) : best;
  }
  return best;
}

bool FaceTriangles::IsStart(const Loop& loop, std::size_t start) const
{
  const std::size_t count = loop.size();
  bool is = true;
  for (std::size_t i = 1; is && i + 1 < count; ++i)
  {
    is = !this->IsFlat(loop[start], loop[(start + i) % count], loop[(start + i + 1) % count]);
  }
  return is;
}

// One of two corners is none, where a face touches itself in a point.
bool FaceTriangles::IsFlat(int a, int b, int c) const
{
  if (this->Touches({ b, c, c }, a))
  {
    return false;
  }
  double u[3], v[3], w[3];
  vtkMath::Subtract(this->Points[b], this->Points[a], u);
  vtkMath::Subtract(this->Points[c], this->Points[b], v);
  vtkMath::Subtract(this->Points[a], this->Points[c], w);
  const double uu = vtkMath::Dot(u, u), vv = vtkMath::Dot(v, v), ww = vtkMath::Dot(w, w);
  return uu == 0.0 || vv == 0.0 || ww == 0.0 || GoesOn(u, v, uu, vv) || GoesOn(v, w, vv, ww) ||
         GoesOn(w, u, ww, uu);
}

// The end of a diagonal from the first vertex; 0 where none leaves an area on both sides.
std::size_t FaceTriangles::FindHalf(const Loop& loop) const
{
  std::vector<std::array<double, 3>> areas(2, { 0.0, 0.0, 0.0 }); // up to each vertex
  for (std::size_t i = 2; i < loop.size(); ++i)
  {
    double u[3], v[3], area[3];
    vtkMath::Subtract(this->Points[loop[i - 1]], this->Points[loop[0]], u);
    vtkMath::Subtract(this->Points[loop[i]], this->Points[loop[0]], v);
    vtkMath::Cross(u, v, area);
    vtkMath::Add(areas.back().data(), area, area);
    areas.push_back({ area[0], area[1], area[2] });
  }
  std::size_t best = 0;
  double largest = 0.0;
  for (std::size_t i = 2; i + 1 < loop.size(); ++i)
  {
    double rest[3];
    vtkMath::Subtract(areas.back().data(), areas[i].data(), rest);
    const double smaller = std::min(vtkMath::Norm(areas[i].data()), vtkMath::Norm(rest));
    best = smaller > largest ? i : best;
    largest = std::max(largest, smaller);
  }
  return best;
}

// Twice.
double FaceTriangles::AreaOf(const Triangle& t) const
{
  double u[3], v[3], cross[3];
  vtkMath::Subtract(this->Points[t[1]], this->Points[t[0]], u);
  vtkMath::Subtract(this->Points[t[2]], this->Points[t[0]], v);
  vtkMath::Cross(u, v, cross);
  return vtkMath::Norm(cross);
}

bool FaceTriangles::SeesAll(int apex, double sign, double flatness) const
{
  const double flat =
    flatness > 0.0 ? flatness * TetrahedralSplit::SizeOf(this->Points, this->NumberOfVertices) : 0.0;
  // A node that was taken out of the faces sees no less, but its neighbours do not have it.
  if (std::none_of(this->Triangles.begin(), this->Triangles.end(),
        [&](const Triangle& t) { return this->Touches(t, apex); }))
  {
    return false;
  }
  double seen = 0.0, hidden = 0.0;
  for (const Triangle& t : this->Triangles)
  {
    if (this->Touches(t, apex))
    {
      continue;
    }
    const double volume = sign * TetrahedralSplit::SixVolumes(this->Points[apex],
                                   this->Points[t[0]], this->Points[t[1]], this->Points[t[2]]);
    const bool isFlat = volume == 0.0 && this->IsFlat(t[0], t[1], t[2]);
    if (!(volume > 0.0 || isFlat || (flat > 0.0 && -volume <= flat * this->AreaOf(t))))
    {
      return false;
    }
    seen += std::max(volume, 0.0);
    hidden += std::max(-volume, 0.0);
  }
  return seen > 0.0 && hidden <= flatness * seen;
}

int FaceTriangles::FindApex(double sign, double flatness) const
{
  const auto smallest =
    static_cast<int>(std::min_element(this->Ids, this->Ids + this->NumberOfVertices) - this->Ids);
  if (this->SeesAll(smallest, sign, flatness))
  {
    return smallest;
  }
  for (int apex = 0; apex < this->NumberOfVertices; ++apex)
  {
    if (this->SeesAll(apex, sign, flatness))
    {
      return apex;
    }
  }
  return -1;
}
