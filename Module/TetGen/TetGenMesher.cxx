#include "TetGenMesher.h"

#include "TetGenRun.h"
#include "TetrahedraSides.h"

#include <tetgen.h>

#include <algorithm>
#include <cstddef>

namespace
{
// As TetGen's own documentation and terminatetetgen() say.
std::string ReasonOf(int code)
{
  switch (code)
  {
    case 0:
      return "";
    case 1:
      return "out of memory";
    case 3:
      return "the surface intersects itself";
    case 4:
      return "two features of the input are too close to each other";
    case 5:
      return "two facets are too close to each other";
    case 10:
      return "the input is invalid";
    default:
      return "an internal error of TetGen, code " + std::to_string(code);
  }
}

void SetPoints(tetgenio& in, const std::vector<double>& points)
{
  in.firstnumber = 0;
  in.numberofpoints = static_cast<int>(points.size() / 3);
  // TetGen deletes what it is given.
  in.pointlist = new REAL[points.size()];
  std::copy(points.begin(), points.end(), in.pointlist);
}

void SetTriangles(tetgenio& in, const std::vector<std::array<int, 3>>& triangles)
{
  in.numberoffacets = static_cast<int>(triangles.size());
  in.facetlist = new tetgenio::facet[triangles.size()];
  for (size_t i = 0; i < triangles.size(); ++i)
  {
    tetgenio::facet& facet = in.facetlist[i];
    tetgenio::init(&facet);
    facet.numberofpolygons = 1;
    facet.polygonlist = new tetgenio::polygon[1];
    tetgenio::init(facet.polygonlist);
    facet.polygonlist->numberofvertices = 3;
    facet.polygonlist->vertexlist = new int[3];
    std::copy(triangles[i].begin(), triangles[i].end(), facet.polygonlist->vertexlist);
  }
}

// Only points that triangles name: TetGen would put the others into tetrahedra.
struct UsedPoints
{
  explicit UsedPoints(const TetGenSurface& surface)
    : Triangles(surface.Triangles)
  {
    std::vector<int> local(surface.Points.size() / 3, -1);
    for (std::array<int, 3>& triangle : this->Triangles)
    {
      for (int& corner : triangle)
      {
        if (local[corner] < 0)
        {
          local[corner] = static_cast<int>(this->Ids.size());
          this->Ids.push_back(corner);
          const double* x = &surface.Points[3 * static_cast<size_t>(corner)];
          this->Points.insert(this->Points.end(), x, x + 3);
        }
        corner = local[corner];
      }
    }
  }

  std::vector<int> Ids;
  std::vector<double> Points;
  std::vector<std::array<int, 3>> Triangles;
};

// `ids`: of the first points that TetGen was given, in `mesh`, whose points are there already.
void TakeMesh(const tetgenio& out, const std::vector<int>& ids, TetGenMesh& mesh)
{
  const int shift = static_cast<int>(mesh.Points.size() / 3) - static_cast<int>(ids.size());
  mesh.Points.insert(
    mesh.Points.end(), out.pointlist + 3 * ids.size(), out.pointlist + 3 * out.numberofpoints);
  mesh.Tetrahedra.resize(static_cast<size_t>(out.numberoftetrahedra));
  for (int i = 0; i < out.numberoftetrahedra; ++i)
  {
    const int* corners = out.tetrahedronlist + static_cast<std::ptrdiff_t>(i) * out.numberofcorners;
    std::transform(corners, corners + 4, mesh.Tetrahedra[i].begin(),
      [&](int corner)
      { return corner < static_cast<int>(ids.size()) ? ids[corner] : corner + shift; });
    TetrahedraSides::TurnPositive(mesh.Points, mesh.Tetrahedra[i]);
  }
}

// New points that were needed only for what is not kept.
void DropUnusedPoints(size_t first, TetGenMesh& mesh)
{
  std::vector<int> number(mesh.Points.size() / 3 - first, -1);
  std::vector<double> kept(mesh.Points.begin(), mesh.Points.begin() + 3 * first);
  for (std::array<int, 4>& tetrahedron : mesh.Tetrahedra)
  {
    for (int& corner : tetrahedron)
    {
      if (corner >= static_cast<int>(first))
      {
        int& known = number[corner - first];
        if (known < 0)
        {
          known = static_cast<int>(kept.size() / 3);
          const double* x = &mesh.Points[3 * static_cast<size_t>(corner)];
          kept.insert(kept.end(), x, x + 3);
        }
        corner = known;
      }
    }
  }
  mesh.Points = std::move(kept);
}

void SetBehavior(const TetGenSettings& settings, tetgenbehavior& behavior)
{
  // p: a surface; Y: it stays as it is; J: points keep their numbers; Q: no output; c: up to the
  // hull; q, a: better tetrahedra.
  std::string switches = settings.FillsHull ? "pYJQc" : "pYJQ";
  const bool hasRatio = settings.MaximumRadiusEdgeRatio > 0.0;
  const bool hasVolume = settings.MaximumVolume > 0.0;
  switches += hasRatio || hasVolume ? "q" : "";
  switches += hasVolume ? "a1" : "";
  behavior.parse_commandline(&switches[0]);
  if (hasRatio || hasVolume)
  {
    // A ratio that no tetrahedron misses, where none is asked for.
    behavior.minratio = hasRatio ? settings.MaximumRadiusEdgeRatio : 1e30;
    behavior.mindihedral = 0.0;
  }
  if (hasVolume)
  {
    behavior.maxvolume = settings.MaximumVolume;
  }
}
}

namespace TetGenMesher
{
//------------------------------------------------------------------------------
TetGenMesh Fill(const TetGenSurface& surface, const TetGenSettings& settings)
{
  TetGenMesh mesh;
  mesh.Points = surface.Points;
  const UsedPoints used(surface);
  tetgenio in, out;
  SetPoints(in, used.Points);
  SetTriangles(in, used.Triangles);
  tetgenbehavior behavior;
  SetBehavior(settings, behavior);
  const int code = TetGenRun::Run(behavior, in, out);
  mesh.IsSelfIntersecting = code == 3;
  mesh.Failure = ReasonOf(code);
  if (code == 0)
  {
    TakeMesh(out, used.Ids, mesh);
    const bool fits =
      TetrahedraSides::Keep(surface.Triangles, !settings.FillsHull, mesh.Tetrahedra);
    mesh.Failure = fits ? "" : "TetGen did not keep the surface, or it encloses nothing";
  }
  if (!mesh.Failure.empty())
  {
    mesh.Tetrahedra.clear();
  }
  DropUnusedPoints(surface.Points.size() / 3, mesh);
  return mesh;
}

//------------------------------------------------------------------------------
TetGenMesh Triangulate(const std::vector<double>& points)
{
  TetGenMesh mesh;
  tetgenio in, out;
  SetPoints(in, points);
  tetgenbehavior behavior;
  char switches[] = "JQ";
  behavior.parse_commandline(switches);
  mesh.Failure = ReasonOf(TetGenRun::Run(behavior, in, out));
  if (mesh.Failure.empty())
  {
    std::vector<int> ids(points.size() / 3);
    for (size_t i = 0; i < ids.size(); ++i)
    {
      ids[i] = static_cast<int>(i);
    }
    mesh.Points = points;
    TakeMesh(out, ids, mesh);
  }
  return mesh;
}
}
