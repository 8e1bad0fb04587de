#include "IsoTriangles.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace
{
constexpr vtkIdType NumberOfParts = 64;
// Of a scalar that is not a number.
constexpr unsigned char NoLevel = 255;

// Edges of a tetrahedron as pairs of its corners, ascending.
using Pair = unsigned char[2];

// The vertices of a cell's triangles, by which of its corners are at or above the value: edges as
// pairs of corners; 0, 3 or 6 of them.
struct CaseOfCell
{
  int Count;
  Pair Vertices[6];
};

constexpr CaseOfCell Triangle(int apex)
{
  CaseOfCell one{ 3, {} };
  int vertex = 0;
  for (int other = 0; other < 4; ++other)
  {
    if (other != apex)
    {
      one.Vertices[vertex][0] = static_cast<unsigned char>(apex < other ? apex : other);
      one.Vertices[vertex][1] = static_cast<unsigned char>(apex < other ? other : apex);
      ++vertex;
    }
  }
  return one;
}

// Around the quadrilateral between corners a, b and c, d: ac, ad, bd, bc.
constexpr CaseOfCell Quadrilateral(int a, int b, int c, int d)
{
  const int around[6][2] = { { a, c }, { a, d }, { b, d }, { a, c }, { b, d }, { b, c } };
  CaseOfCell one{ 6, {} };
  for (int vertex = 0; vertex < 6; ++vertex)
  {
    const int p = around[vertex][0];
    const int q = around[vertex][1];
    one.Vertices[vertex][0] = static_cast<unsigned char>(p < q ? p : q);
    one.Vertices[vertex][1] = static_cast<unsigned char>(p < q ? q : p);
  }
  return one;
}

constexpr CaseOfCell Cases[16] = { { 0, {} }, Triangle(0), Triangle(1), Quadrilateral(0, 1, 2, 3),
  Triangle(2), Quadrilateral(0, 2, 1, 3), Quadrilateral(1, 2, 0, 3), Triangle(3), Triangle(3),
  Quadrilateral(0, 3, 1, 2), Quadrilateral(1, 3, 0, 2), Triangle(2), Quadrilateral(2, 3, 0, 1),
  Triangle(1), Triangle(0), { 0, {} } };

// Reaches both ends to the last bit: edges that end in one point meet there.
float Between(float from, float to, float share)
{
  return share < 1.0f ? from + share * (to - from) : to;
}

template <class Function>
void ForParts(const Function& function)
{
  vtkSMPTools::For(0, NumberOfParts, 1,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType part = first; part < last; ++part)
      {
        function(part);
      }
    });
}
}

//------------------------------------------------------------------------------
void IsoTriangles::FindLevels(const std::vector<float>& scalars, const std::vector<float>& values)
{
  this->Levels.resize(scalars.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(scalars.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType id = begin; id < end; ++id)
      {
        const float scalar = scalars[id];
        int level = 0;
        for (const float value : values)
        {
          level += (scalar > value ? 1 : 0) + (scalar >= value ? 1 : 0);
        }
        this->Levels[id] = std::isfinite(scalar) ? static_cast<unsigned char>(level) : NoLevel;
      }
    });
}

//------------------------------------------------------------------------------
void IsoTriangles::FindCells(
  const std::vector<int>& corners, vtkIdType begin, vtkIdType end, Part& part) const
{
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    const int* ids = &corners[4 * cell];
    const unsigned char a = this->Levels[ids[0]], b = this->Levels[ids[1]];
    const unsigned char c = this->Levels[ids[2]], d = this->Levels[ids[3]];
    const bool isInvalid = std::max(std::max(a, b), std::max(c, d)) == NoLevel;
    part.NumberOfInvalidCells += isInvalid ? 1 : 0;
    if ((a != b || a != c || a != d) && !isInvalid)
    {
      part.Cells.push_back(static_cast<int>(cell));
    }
  }
}

//------------------------------------------------------------------------------
void IsoTriangles::CutCells(const std::vector<int>& corners, const std::vector<float>& scalars,
  int index, Part& part) const
{
  const int level = 2 * index + 1;
  const double value = this->Values[index];
  part.Edges.clear();
  for (const int cell : part.Cells)
  {
    const int* ids = &corners[4 * static_cast<size_t>(cell)];
    int above = 0;
    int beyond = 0;
    for (int i = 0; i < 4; ++i)
    {
      above |= this->Levels[ids[i]] >= level ? 1 << i : 0;
      beyond |= this->Levels[ids[i]] > level ? 1 << i : 0;
    }
    // Of a cell that rises from a face on the surface, that face.
    const bool isFace = above == 15 && (beyond & (beyond - 1)) == 0;
    const CaseOfCell& found = Cases[isFace ? beyond : above];
    for (int vertex = 0; vertex < found.Count; ++vertex)
    {
      const int from = ids[found.Vertices[vertex][0]];
      const int to = ids[found.Vertices[vertex][1]];
      const double start = scalars[from];
      const auto share = static_cast<float>((value - start) / (scalars[to] - start));
      // On a point it is the same vertex for all edges that end there.
      part.Edges.push_back({ share < 1.0f ? from : to, share > 0.0f ? to : from, share });
    }
  }
}

//------------------------------------------------------------------------------
bool IsoTriangles::Faces::IsNew(const std::array<int, 3>& points, size_t numberOfPoints)
{
  // Most surfaces have none.
  this->LastOfPoint.resize(numberOfPoints, -1);
  int& last = this->LastOfPoint[points[0]];
  for (int face = last; face >= 0; face = this->Items[face][2])
  {
    if (this->Items[face][0] == points[1] && this->Items[face][1] == points[2])
    {
      return false;
    }
  }
  this->Items.push_back({ points[1], points[2], last });
  last = static_cast<int>(this->Items.size()) - 1;
  return true;
}

//------------------------------------------------------------------------------
bool IsoTriangles::IsNew(const Edge* triangle, Faces& faces) const
{
  std::array<int, 3> points;
  int onPoints = 0;
  for (int i = 0; i < 3; ++i)
  {
    points[i] = triangle[i].From;
    onPoints += triangle[i].From == triangle[i].To ? 1 : 0;
  }
  if (onPoints < 3)
  {
    return true;
  }
  // A face comes from the cells on both of its sides; a cell that touches the value gives a point.
  std::sort(points.begin(), points.end());
  const bool isFace = points[0] != points[1] && points[1] != points[2];
  return isFace && faces.IsNew(points, this->Levels.size());
}

//------------------------------------------------------------------------------
int IsoTriangles::FindVertex(const Edge& edge)
{
  int& last = this->LastOfPoint[edge.From];
  for (int vertex = last; vertex >= 0; vertex = this->Before[vertex])
  {
    if (this->Edges[vertex].To == edge.To)
    {
      return vertex;
    }
  }
  this->Edges.push_back(edge);
  this->Before.push_back(last);
  last = static_cast<int>(this->Edges.size()) - 1;
  return last;
}

//------------------------------------------------------------------------------
void IsoTriangles::AppendSurface(const std::vector<Part>& parts, float value)
{
  this->LastOfPoint.assign(this->Levels.size(), -1);
  const size_t first = this->Triangles.size() / 3;
  Faces faces;
  for (const Part& part : parts)
  {
    for (size_t i = 0; i < part.Edges.size(); i += 3)
    {
      if (IsNew(&part.Edges[i], faces))
      {
        for (size_t vertex = i; vertex < i + 3; ++vertex)
        {
          this->Triangles.push_back(this->FindVertex(part.Edges[vertex]));
        }
      }
    }
  }
  this->Surfaces.push_back({ value, first, this->Triangles.size() / 3 });
}

//------------------------------------------------------------------------------
void IsoTriangles::AppendCells(const std::vector<Part>& parts)
{
  this->Cells.clear();
  this->NumberOfInvalidCells = 0;
  for (const Part& part : parts)
  {
    this->Cells.insert(this->Cells.end(), part.Cells.begin(), part.Cells.end());
    this->NumberOfInvalidCells += part.NumberOfInvalidCells;
  }
}

//------------------------------------------------------------------------------
void IsoTriangles::Cut(const std::vector<int>& corners, const std::vector<float>& scalars,
  std::vector<float> values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  this->Values = values;
  this->FindLevels(scalars, values);
  const auto cells = static_cast<vtkIdType>(corners.size() / 4);
  std::vector<Part> parts(NumberOfParts);
  ForParts(
    [&](vtkIdType part)
    {
      this->FindCells(corners, cells * part / NumberOfParts, cells * (part + 1) / NumberOfParts,
        parts[part]);
    });
  this->AppendCells(parts);
  this->Surfaces.clear();
  this->Edges.clear();
  this->Before.clear();
  this->Triangles.clear();
  for (size_t index = 0; index < values.size(); ++index)
  {
    ForParts([&](vtkIdType part)
      { this->CutCells(corners, scalars, static_cast<int>(index), parts[part]); });
    this->AppendSurface(parts, values[index]);
  }
}

//------------------------------------------------------------------------------
void IsoTriangles::Move(const std::vector<int>& corners, const std::vector<float>& points)
{
  this->Vertices.resize(4 * this->Edges.size());
  std::atomic<bool> isAnyLost(false);
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Edges.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType id = begin; id < end; ++id)
      {
        const Edge& edge = this->Edges[id];
        const float* from = &points[4 * static_cast<size_t>(edge.From)];
        const float* to = &points[4 * static_cast<size_t>(edge.To)];
        float* vertex = &this->Vertices[4 * id];
        for (int i = 0; i < 3; ++i)
        {
          vertex[i] = Between(from[i], to[i], edge.Share);
        }
        const bool isFinite = std::isfinite(vertex[0] + vertex[1] + vertex[2]);
        vertex[3] = isFinite ? 1.0f : 0.0f;
        if (!isFinite)
        {
          std::fill_n(vertex, 3, 0.0f);
          isAnyLost = true;
        }
      }
    });
  this->NumberOfLostCells = 0;
  if (isAnyLost)
  {
    this->CountLostCells(corners, points);
  }
}

//------------------------------------------------------------------------------
void IsoTriangles::CountLostCells(
  const std::vector<int>& corners, const std::vector<float>& points)
{
  for (const int cell : this->Cells)
  {
    const int* ids = &corners[4 * static_cast<size_t>(cell)];
    const bool isLost = std::any_of(ids, ids + 4,
      [&points](int id)
      {
        const float* point = &points[4 * static_cast<size_t>(id)];
        return !std::isfinite(point[0] + point[1] + point[2]);
      });
    this->NumberOfLostCells += isLost ? 1 : 0;
  }
}

//------------------------------------------------------------------------------
void IsoTriangles::Shade(const std::vector<float>& gradients)
{
  this->Gradients.resize(4 * this->Edges.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Edges.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType vertex = begin; vertex < end; ++vertex)
      {
        const Edge& edge = this->Edges[vertex];
        for (int i = 0; i < 4; ++i)
        {
          const float from = gradients[4 * static_cast<size_t>(edge.From) + i];
          const float to = gradients[4 * static_cast<size_t>(edge.To) + i];
          this->Gradients[4 * vertex + i] = Between(from, to, edge.Share);
        }
      }
    });
}

//------------------------------------------------------------------------------
std::vector<int> IsoTriangles::FindPoints(std::size_t numberOfPoints) const
{
  std::vector<unsigned char> used(numberOfPoints, 0);
  for (const Edge& edge : this->Edges)
  {
    used[edge.From] = used[edge.To] = 1;
  }
  std::vector<int> points;
  for (size_t id = 0; id < numberOfPoints; ++id)
  {
    if (used[id] != 0)
    {
      points.push_back(static_cast<int>(id));
    }
  }
  return points;
}
