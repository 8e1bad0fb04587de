// Polyhedra that cannot be drawn: each is counted and named, and the cells about it go out.
#include "ConvexCellsTesting.h"
#include "PolyhedronSurface.h"
#include "VTKVersions.h"

#include "vtkCellArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <limits>
#include <numeric>
#include <string>

namespace
{
using namespace ConvexCellsTesting;

const Faces Cube = BoxFaces({ 0, 1, 2, 3, 4, 5, 6, 7 });

struct BadCell
{
  const char* Name;
  Faces CellFaces;
  const char* Summary;
};

// 0 to 7 a box; 8 not finite; 9 hidden; 10 to 13 a tetrahedron elsewhere; 14 on the box's top.
vtkSmartPointer<vtkUnstructuredGrid> MakePoints()
{
  auto grid = MakeGrid({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 }, { std::nan(""), 0, 0 }, { 0, 0, 4 }, { 3, 0, 0 },
    { 4, 0, 0 }, { 3, 1, 0 }, { 3, 0, 1 }, { .5, .5, 1 } });
  vtkNew<vtkUnsignedCharArray> hidden;
  hidden->SetName(vtkDataSetAttributes::GhostArrayName());
  hidden->SetNumberOfValues(grid->GetNumberOfPoints());
  hidden->FillValue(0);
  hidden->SetValue(9, vtkDataSetAttributes::HIDDENPOINT);
  grid->GetPointData()->AddArray(hidden);
  return grid;
}

Faces Tetrahedron(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d)
{
  return { { a, c, b }, { a, b, d }, { b, c, d }, { a, d, c } };
}

Faces With(Faces faces, const std::vector<vtkIdType>& face)
{
  faces.push_back(face);
  return faces;
}

Faces Changed(std::size_t index, const std::vector<vtkIdType>& face)
{
  Faces faces = Cube;
  faces[index] = face;
  return faces;
}

// Every edge belongs to two of these triangles, and yet they have one side only.
const Faces ProjectivePlane = { { 1, 2, 3 }, { 1, 3, 4 }, { 1, 4, 5 }, { 1, 5, 6 }, { 1, 2, 6 },
  { 2, 3, 5 }, { 3, 4, 6 }, { 2, 4, 5 }, { 3, 5, 6 }, { 2, 4, 6 } };

std::vector<BadCell> BadCells()
{
  const char* open = "1 vtkPolyhedron (open surface)";
  const char* list = "1 vtkPolyhedron (wrong list of faces)";
  Faces pieces = Tetrahedron(0, 1, 3, 4);
  for (const auto& face : Tetrahedron(10, 11, 12, 13))
  {
    pieces.push_back(face);
  }
  Faces joined = Tetrahedron(0, 1, 3, 4);
  for (const auto& face : Tetrahedron(0, 1, 10, 13))
  {
    joined.push_back(face);
  }
  return { { "joined at an edge", joined, open },
    { "no top", Faces(Cube.begin(), Cube.end() - 1), open },
    { "top twice", With(Cube, Cube[5]), open }, { "wall inside", With(Cube, { 0, 1, 6, 7 }), open },
    { "one side", ProjectivePlane, open },
    { "hanging point", Changed(5, { 4, 14, 5, 6, 7 }), open },
    { "edge for a face", With(Cube, { 4, 6 }), list },
    { "two points thrice", Changed(5, { 4, 5, 4 }), list },
    { "face through a point twice", Changed(5, { 4, 14, 5, 14, 6, 7 }), list },
    { "id too large", Changed(5, { 4, 5, 6, 15 }), list },
    { "id below 0", Changed(5, { 4, 5, 6, -1 }), list },
    { "two pieces", pieces, "1 vtkPolyhedron (several pieces)" },
    { "flat", { { 0, 1, 2, 3 }, { 3, 2, 1, 0 } }, "1 of zero volume" },
    { "flat, of four faces", Tetrahedron(0, 1, 2, 3), "1 of zero volume" },
    { "not finite", Tetrahedron(0, 1, 3, 8), "1 with a point that is not finite" },
    { "hidden", Tetrahedron(0, 1, 3, 9), "1 ghost or hidden" } };
}

vtkIdType CountInvalid(const std::string& summary)
{
  return summary.find("(concave") == std::string::npos &&
         summary.find("vtkPolyhedron (") != std::string::npos;
}

void TestBadCell(const BadCell& bad)
{
  auto grid = MakePoints();
  AddPolyhedron(grid, Tetrahedron(10, 11, 12, 13));
  AddPolyhedron(grid, bad.CellFaces);
  AddPolyhedron(grid, Cube);
  for (const bool tetrahedraOnly : { false, true })
  {
    auto filter = Run(grid, tetrahedraOnly);
    vtkUnstructuredGrid* output = filter->GetOutput();
    if (!CHECK_EQUAL(filter->GetLeftOutSummary(), std::string("cells left out: ") + bad.Summary) ||
        !CHECK_EQUAL(output->GetNumberOfCells(), tetrahedraOnly ? 7 : 2))
    {
      std::cerr << "  " << bad.Name << "\n";
    }
    CHECK_EQUAL(filter->GetNumberOfSkippedCells(), 1);
    CHECK_EQUAL(filter->GetNumberOfInvalidCells(), CountInvalid(bad.Summary));
    CHECK(Near(VolumeWithin(output), 1.0 + 1.0 / 6.0));
  }
}

// All in one mesh: the line names them by kind.
void TestAllTogether()
{
  auto grid = MakePoints();
  for (const BadCell& bad : BadCells())
  {
    AddPolyhedron(grid, bad.CellFaces);
  }
  AddPolyhedron(grid, Cube);
  auto filter = Run(grid, false);
  CHECK_EQUAL(filter->GetLeftOutSummary(),
    std::string("cells left out: 5 vtkPolyhedron (wrong list of faces), 6 vtkPolyhedron (open "
                "surface), 1 vtkPolyhedron (several pieces), 2 of zero volume, 1 ghost or hidden, "
                "1 with a point that is not finite"));
  CHECK_EQUAL(filter->GetNumberOfInvalidCells(), 12);
  CHECK_EQUAL(filter->GetNumberOfZeroVolumeCells(), 2);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 1);
}

// Lists that no VTK method would write, but a file may hold.
void TestStreams()
{
  std::vector<vtkIdType> canonical(8);
  std::iota(canonical.begin(), canonical.end(), vtkIdType{ 0 });
  const std::vector<vtkIdType> good = { 4, 3, 0, 2, 1, 3, 0, 1, 4, 3, 1, 2, 4, 3, 0, 4, 2 };
  PolyhedronSurface surface;
  const auto read = [&](const std::vector<vtkIdType>& stream, std::size_t length)
  { return surface.Read(stream.data(), static_cast<vtkIdType>(length), canonical.data(), 8); };
  CHECK(read(good, good.size()));
  CHECK(surface.Orient() == PolyhedronSurface::Defect::None);
  for (std::size_t length = 0; length < good.size(); ++length)
  {
    CHECK(!read(good, length));
  }
  for (const vtkIdType number : { std::numeric_limits<vtkIdType>::min(), vtkIdType{ -1 },
         vtkIdType{ 0 }, vtkIdType{ 3 }, vtkIdType{ 5 }, std::numeric_limits<vtkIdType>::max() })
  {
    for (const std::size_t place : { 0, 1, 5 })
    {
      std::vector<vtkIdType> wrong = good;
      wrong[place] = number;
      CHECK(read(wrong, wrong.size()) == (place != 0 && number == 3));
    }
  }
}

// A box and a tetrahedron, after `spoil` was given the arrays of faces of the box.
template <typename Spoil>
void CheckSpoilt(Spoil spoil)
{
  auto grid = MakePoints();
  AddPolyhedron(grid, Cube);
  AddCell(grid, VTK_TETRA, { 10, 11, 12, 13 });
  const std::array<vtkObject*, 2> arrays = GetFaceArrays(grid);
  spoil(arrays[0], arrays[1]);
  for (const bool tetrahedraOnly : { false, true })
  {
    auto filter = Run(grid, tetrahedraOnly);
    CHECK_EQUAL(filter->GetLeftOutSummary(),
      std::string("cells left out: 1 vtkPolyhedron (wrong list of faces)"));
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 1);
  }
}

// Faces that do not lie in their arrays, which each VTK keeps in its own way.
void TestArrays()
{
  for (const vtkIdType wrong : { vtkIdType{ -1 }, vtkIdType{ 1000000 } })
  {
    CheckSpoilt(
      [wrong](vtkObject*, vtkObject* locations)
      {
        const vtkIdType faces[6] = { 0, 1, 2, 3, 4, wrong };
        if (auto* cells = vtkCellArray::SafeDownCast(locations))
        {
          cells->ReplaceCellAtId(0, 6, faces);
        }
        else if (auto* starts = vtkIdTypeArray::SafeDownCast(locations))
        {
          starts->SetValue(0, wrong);
        }
      });
    CheckSpoilt(
      [wrong](vtkObject* faces, vtkObject*)
      {
        const vtkIdType corners[4] = { 0, 4, 7, wrong };
        if (auto* cells = vtkCellArray::SafeDownCast(faces))
        {
          cells->ReplaceCellAtId(0, 4, corners);
        }
        else if (auto* stream = vtkIdTypeArray::SafeDownCast(faces))
        {
          stream->SetValue(0, wrong);
        }
      });
  }
}
}

int TestConvexCellsBadPolyhedra(int, char*[])
{
  for (const BadCell& bad : BadCells())
  {
    TestBadCell(bad);
  }
  TestAllTogether();
  TestStreams();
  TestArrays();
  return Result();
}
