// M3: a cell has one image, however its corners are listed.

#include "PolyhedraScene.h"
#include "TestMeshes.h"

#include "vtkCellType.h"

#include <algorithm>

namespace
{
// Whether corners that share an edge of the listed hexahedron differ in one coordinate.
bool IsHexahedron(const int (&corner)[8])
{
  for (int i = 0; i < 8; ++i)
  {
    const int next = i % 4 == 3 ? i - 3 : i + 1;
    for (const int other : { next, (i + 4) % 8 })
    {
      const int different = corner[i] ^ corner[other];
      if (different != 1 && different != 2 && different != 4)
      {
        return false;
      }
    }
  }
  return true;
}

// The 24 turns of a cube's corners and their 24 mirror images, as lists of corners; bit i of a
// corner is its place along axis i.
std::vector<std::vector<vtkIdType>> Listings()
{
  std::vector<std::vector<vtkIdType>> listings;
  int corner[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  do
  {
    if (IsHexahedron(corner))
    {
      listings.emplace_back(corner, corner + 8);
    }
  } while (std::next_permutation(corner, corner + 8));
  return listings;
}

TestMeshes::Grid Hexahedron(const std::vector<vtkIdType>& listing)
{
  // Corner i of a voxel is named by the same bits.
  auto grid = TestMeshes::Grid::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(i & 1 ? 0.5 : -0.5, i & 2 ? 0.4 : -0.4, i & 4 ? 0.45 : -0.45);
  }
  grid->SetPoints(points);
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, listing.data());
  TestMeshes::SetField(grid, TestMeshes::Waves);
  return grid;
}

void CheckSame(TestChecks& checks, PolyhedraScene& scene, vtkImageData* first, int line)
{
  scene.Render();
  const double difference = TestScene::Difference(first, scene.Mapper->GetCapturedImage());
  // Where a ray grazes a face, its scalar takes up the rounding of where they meet.
  const bool good = difference >= 0.0 && difference <= (scene.IsAdditive() ? 2e-6 : 5e-6);
  checks.Check(good, "same image", line, std::to_string(1e6 * difference) + "e-6");
}

void CheckTetrahedron(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  PolyhedraScene scene(mapper.Make());
  std::vector<int> numbering = { 0, 1, 2, 3 };
  scene.SetMesh(TestMeshes::Tetrahedron(numbering));
  scene.Render();
  auto first = scene.CopyCaptured();
  CHECK(scene.CountLitPixels() > 1000);
  while (std::next_permutation(numbering.begin(), numbering.end()))
  {
    scene.SetMesh(TestMeshes::Tetrahedron(numbering));
    CheckSame(checks, scene, first, __LINE__);
  }
}

void CheckHexahedron(TestChecks& checks, const PolyhedraMappers::Entry& mapper)
{
  PolyhedraScene scene(mapper.Make());
  const std::vector<std::vector<vtkIdType>> listings = Listings();
  CHECK(listings.size() == 48);
  scene.SetMesh(Hexahedron({ 0, 1, 3, 2, 4, 5, 7, 6 }));
  scene.Render();
  auto first = scene.CopyCaptured();
  CHECK(scene.CountLitPixels() > 1000);
  for (const std::vector<vtkIdType>& listing : listings)
  {
    scene.SetMesh(Hexahedron(listing));
    CheckSame(checks, scene, first, __LINE__);
  }
}
}

int TestPolyhedraNumbering(int, char*[])
{
  TestChecks checks;
  for (const PolyhedraMappers::Entry& mapper : PolyhedraMappers::All())
  {
    CheckTetrahedron(checks, mapper);
    CheckHexahedron(checks, mapper);
  }
  return checks.Result();
}
