#include "TetrahedraSides.h"

#include "ExactOrientation.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace
{
// Corners of the face across from corner i, counter-clockwise seen from outside.
constexpr int FaceOf[4][3] = { { 1, 2, 3 }, { 0, 3, 2 }, { 0, 1, 3 }, { 0, 2, 1 } };

// A triangle with its corners ascending, and whether that took an odd number of exchanges.
struct Face
{
  std::array<int, 3> Corners;
  bool IsOdd = false;
  int Tetrahedron = -1; // -1: of the surface
  int Number = 0;       // 0 .. 3

  Face(int a, int b, int c)
    : Corners{ { a, b, c } }
  {
    this->Order(0, 1);
    this->Order(1, 2);
    this->Order(0, 1);
  }
  void Order(int i, int j)
  {
    if (this->Corners[j] < this->Corners[i])
    {
      std::swap(this->Corners[i], this->Corners[j]);
      this->IsOdd = !this->IsOdd;
    }
  }
};

class Flood
{
public:
  enum Side : signed char
  {
    Unknown = 0,
    Inside = 1,
    Outside = -1
  };

  Flood(const std::vector<std::array<int, 3>>& surface,
    const std::vector<std::array<int, 4>>& tetrahedra)
    : Sides(tetrahedra.size(), Unknown)
    , Across(4 * tetrahedra.size(), -1)
  {
    std::vector<Face> faces;
    faces.reserve(surface.size() + 4 * tetrahedra.size());
    for (const std::array<int, 3>& t : surface)
    {
      faces.emplace_back(t[0], t[1], t[2]);
    }
    for (size_t i = 0; i < tetrahedra.size(); ++i)
    {
      for (int f = 0; f < 4; ++f)
      {
        const int* corner = FaceOf[f];
        faces.emplace_back(
          tetrahedra[i][corner[0]], tetrahedra[i][corner[1]], tetrahedra[i][corner[2]]);
        faces.back().Tetrahedron = static_cast<int>(i);
        faces.back().Number = f;
      }
    }
    // Of one triangle the surface comes first.
    std::sort(faces.begin(), faces.end(),
      [](const Face& a, const Face& b)
      { return std::tie(a.Corners, a.Tetrahedron) < std::tie(b.Corners, b.Tetrahedron); });
    this->Match(faces);
  }

  bool Run()
  {
    while (!this->Front.empty() && this->Fits)
    {
      const int tetrahedron = this->Front.back();
      this->Front.pop_back();
      for (int f = 0; f < 4; ++f)
      {
        const int next = this->Across[4 * static_cast<size_t>(tetrahedron) + f];
        if (next >= 0)
        {
          this->Mark(next, this->Sides[tetrahedron]);
        }
      }
    }
    return this->Fits;
  }

  std::vector<Side> Sides;

private:
  void Match(const std::vector<Face>& faces)
  {
    for (size_t begin = 0, end = 0; begin < faces.size(); begin = end)
    {
      end = begin + 1;
      while (end < faces.size() && faces[end].Corners == faces[begin].Corners)
      {
        ++end;
      }
      if (faces[begin].Tetrahedron < 0)
      {
        this->MarkSides(&faces[begin], &faces[begin] + (end - begin));
      }
      else if (end - begin == 2)
      {
        this->Link(faces[begin], faces[begin + 1]);
      }
    }
  }

  void MarkSides(const Face* begin, const Face* end)
  {
    this->Fits = this->Fits && end - begin >= 2 && begin[1].Tetrahedron >= 0;
    for (const Face* face = begin + 1; face < end && this->Fits; ++face)
    {
      this->Mark(face->Tetrahedron, face->IsOdd == begin->IsOdd ? Inside : Outside);
    }
  }

  void Link(const Face& a, const Face& b)
  {
    this->Across[4 * static_cast<size_t>(a.Tetrahedron) + a.Number] = b.Tetrahedron;
    this->Across[4 * static_cast<size_t>(b.Tetrahedron) + b.Number] = a.Tetrahedron;
  }

  void Mark(int tetrahedron, Side side)
  {
    Side& known = this->Sides[tetrahedron];
    if (known == Unknown)
    {
      known = side;
      this->Front.push_back(tetrahedron);
    }
    this->Fits = this->Fits && known == side;
  }

  std::vector<int> Across; // four per tetrahedron; -1 at the surface and the hull
  std::vector<int> Front;
  bool Fits = true;
};
}

namespace TetrahedraSides
{
//------------------------------------------------------------------------------
void TurnPositive(const std::vector<double>& points, std::array<int, 4>& tetrahedron)
{
  const auto at = [&](int i) { return &points[3 * static_cast<size_t>(tetrahedron[i])]; };
  if (ExactOrientation::SideOfPoint(at(0), at(1), at(2), at(3)) < 0)
  {
    std::swap(tetrahedron[2], tetrahedron[3]);
  }
}

//------------------------------------------------------------------------------
bool Keep(const std::vector<std::array<int, 3>>& surface, bool inside,
  std::vector<std::array<int, 4>>& tetrahedra)
{
  Flood flood(surface, tetrahedra);
  if (!flood.Run())
  {
    return false;
  }
  const Flood::Side kept = inside ? Flood::Inside : Flood::Outside;
  size_t count = 0;
  for (size_t i = 0; i < tetrahedra.size(); ++i)
  {
    if (flood.Sides[i] == kept)
    {
      tetrahedra[count++] = tetrahedra[i];
    }
  }
  tetrahedra.resize(count);
  return true;
}
}
