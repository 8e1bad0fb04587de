// Through which faces of tetrahedra rays leave towards a neighbour, and which cells they enter the mesh through,
// against where the fourth corner lies: of scalars per point and per cell, for every instruction set.

#include "TestScene.h"
#include "TileArrays.h"
#include "TileCells.h"
#include "TileClusters.h"
#include "TileMesh.h"
#include "TileVertices.h"
#include "TileView.h"

#include <hwy/highway.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace
{
struct ProjectedMesh
{
  TileMesh Mesh;
  TileView View;
  TileVertices Vertices;
  TileCells Cells;

  ProjectedMesh(int n, const glm::dvec3& eye, bool onePerCell)
  {
    TileArrays arrays(n);
    arrays.LookFrom(eye, 35.0, 200, 150);
    this->View.Build(arrays.Scene.Camera);
    this->Mesh.Build(arrays.Points, arrays.Corners, [](double) {});
    std::vector<float> scalars(arrays.Scalars);
    scalars.resize(onePerCell ? this->Mesh.Source.size() : scalars.size());
    this->Mesh.SetScalars(scalars, onePerCell);
    this->Vertices.Transform(this->Mesh.Points, this->View);
    TileClusters clusters;
    clusters.Build(this->Mesh);
    clusters.SeeAll();
    this->Cells.Project(this->Mesh, this->View, this->Vertices, clusters);
  }

  const float* PointOf(int cell, int corner) const
  {
    return &this->Vertices.Values[4 * static_cast<std::size_t>(this->Mesh.Corners[4 * cell + corner])];
  }

  /// Whether the cell lies nearer than its face where the corner beside that is: there rays leave through it.
  bool Leaves(int cell, int face) const
  {
    const int* side = TileMesh::FaceCorners[face];
    const float *a = this->PointOf(cell, side[0]), *b = this->PointOf(cell, side[1]);
    const float *c = this->PointOf(cell, side[2]), *p = this->PointOf(cell, face);
    auto area = [](const float* q, const float* r, const float* s)
    { return (double(r[0]) - q[0]) * (double(s[1]) - q[1]) - (double(r[1]) - q[1]) * (double(s[0]) - q[0]); };
    const double all = area(a, b, c);
    return (area(p, b, c) * a[2] + area(a, p, c) * b[2] + area(a, b, p) * c[2]) / all < p[2];
  }

  /// As in TileCells::Faces, of a cell whose faces are certain.
  int FindFaces(int cell) const
  {
    int faces = 0;
    for (int f = 0; f < 4; ++f)
    {
      const bool leaves = this->Leaves(cell, f), isLinked = this->Mesh.Neighbours[4 * cell + f] >= 0;
      faces |= leaves && isLinked ? 1 << f : 0;
      faces |= !leaves && !isLinked ? TileCells::Entered : 0;
    }
    return faces;
  }
};

void CheckMesh(TestChecks& checks, int n, const glm::dvec3& eye)
{
  const ProjectedMesh points(n, eye, false), cells(n, eye, true);
  CHECK(points.Cells.Faces == cells.Cells.Faces);
  CHECK(points.Cells.Boxes == cells.Cells.Boxes);
  int certain = 0, wrong = 0, entered = 0;
  for (int cell = 0; cell < points.Mesh.GetNumberOfCells(); ++cell)
  {
    const int faces = points.Cells.Faces[cell];
    if ((faces & (TileCells::Unsure | TileCells::Exact)) == 0)
    {
      ++certain;
      wrong += faces == points.FindFaces(cell) ? 0 : 1;
      entered += (faces & TileCells::Entered) != 0 ? 1 : 0;
    }
  }
  CHECK(certain > 0.9 * points.Mesh.GetNumberOfCells());
  CHECK(wrong == 0);
  CHECK(entered > n * n);
}
}

int TestTileFaces(int, char*[])
{
  TestChecks checks;
  for (const int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    hwy::GetChosenTarget().Update(target);
    // The last group of cells is not a full one.
    CheckMesh(checks, 5, { 1.9, 1.5, 3.5 });
    CheckMesh(checks, 3, { -2.1, 3.3, -1.2 });
  }
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  return checks.Result();
}
