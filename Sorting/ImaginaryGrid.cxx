#include "ImaginaryGrid.h"

#include "Convexification.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTetra.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{
void AppendPoints(vtkPoints* input, const std::vector<double>& added, vtkUnstructuredGrid* output)
{
  const vtkIdType count = input->GetNumberOfPoints();
  const vtkIdType more = static_cast<vtkIdType>(added.size() / 3);
  vtkNew<vtkPoints> points;
  // Floats would move the new points out of the planes that they lie in.
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count + more);
  points->GetData()->InsertTuples(0, count, 0, input->GetData());
  for (vtkIdType i = 0; i < more; ++i)
  {
    points->SetPoint(count + i, &added[3 * i]);
  }
  output->SetPoints(points);
}

// `attributes` become those of `input`, with zeros for `more` elements after them.
void AppendAttributes(
  vtkDataSetAttributes* input, vtkIdType count, vtkIdType more, vtkDataSetAttributes* attributes)
{
  attributes->Initialize();
  attributes->CopyAllOn();
  attributes->CopyAllocate(input, count + more);
  attributes->CopyData(input, 0, count, 0);
  for (vtkIdType i = count; i < count + more; ++i)
  {
    attributes->NullData(i);
  }
}

void AppendTetrahedron(const ImaginaryCells& cells, int cell, vtkUnstructuredGrid* output)
{
  const int* face = &cells.FaceCorners[cells.FaceOffsets[cells.CellOffsets[cell]]];
  const auto isNew = [face](int corner) { return std::find(face, face + 3, corner) == face + 3; };
  // Seen from the fourth corner the first face, which turns outward, is clockwise.
  const vtkIdType corners[4] = { face[0], face[2], face[1],
    *std::find_if(face + 3, face + 6, isNew) };
  output->InsertNextCell(VTK_TETRA, 4, corners);
}

void AppendCells(const ImaginaryCells& cells, vtkUnstructuredGrid* output)
{
  vtkNew<vtkIdList> stream;
  for (int cell = 0; cell < cells.GetNumberOfCells(); ++cell)
  {
    if (cells.AreTetrahedra)
    {
      AppendTetrahedron(cells, cell, output);
      continue;
    }
    stream->Reset();
    stream->InsertNextId(cells.CellOffsets[cell + 1] - cells.CellOffsets[cell]);
    for (int face = cells.CellOffsets[cell]; face < cells.CellOffsets[cell + 1]; ++face)
    {
      stream->InsertNextId(cells.FaceOffsets[face + 1] - cells.FaceOffsets[face]);
      for (int i = cells.FaceOffsets[face]; i < cells.FaceOffsets[face + 1]; ++i)
      {
        stream->InsertNextId(cells.FaceCorners[i]);
      }
    }
    output->InsertNextCell(VTK_POLYHEDRON, stream);
  }
}

vtkSmartPointer<vtkIdTypeArray> MakeContacts(const ImaginaryCells& cells)
{
  auto contacts = vtkSmartPointer<vtkIdTypeArray>::New();
  contacts->SetName("ImaginaryContacts");
  contacts->SetNumberOfComponents(5);
  contacts->SetNumberOfTuples(static_cast<vtkIdType>(cells.Contacts.size()));
  vtkIdType* value = contacts->GetPointer(0);
  for (const CellComplex::Contact& contact : cells.Contacts)
  {
    value = std::copy_n(contact.Points, 3, value);
    value = std::copy_n(contact.Cells, 2, value);
  }
  return contacts;
}

// The first cell that `Imaginary` marks; the number of cells where there is none.
vtkIdType FindFirst(vtkDataSet* grid)
{
  auto* marks = vtkUnsignedCharArray::SafeDownCast(grid->GetCellData()->GetArray("Imaginary"));
  if (!marks || marks->GetNumberOfTuples() != grid->GetNumberOfCells())
  {
    return grid->GetNumberOfCells();
  }
  const unsigned char* begin = marks->GetPointer(0);
  const unsigned char* end = begin + marks->GetNumberOfTuples();
  return std::find_if(begin, end, [](unsigned char mark) { return mark != 0; }) - begin;
}

bool AreLast(vtkDataSet* grid, vtkIdType first)
{
  auto* marks = vtkUnsignedCharArray::SafeDownCast(grid->GetCellData()->GetArray("Imaginary"));
  const unsigned char* begin = marks->GetPointer(0);
  return std::all_of(begin + first, begin + marks->GetNumberOfTuples(),
    [](unsigned char mark) { return mark != 0; });
}

bool TakeContacts(vtkIdTypeArray* contacts, vtkDataSet* grid, ImaginaryCells& cells)
{
  const vtkIdType points = grid->GetNumberOfPoints();
  std::vector<CellComplex::Contact> taken;
  for (vtkIdType i = 0; contacts->GetNumberOfComponents() == 5 && i < contacts->GetNumberOfTuples();
       ++i)
  {
    const vtkIdType* row = contacts->GetPointer(5 * i);
    const auto isIn = [](vtkIdType id, vtkIdType count) { return id >= 0 && id < count; };
    if (!isIn(row[0], points) || !isIn(row[1], points) || !isIn(row[2], points) ||
        !isIn(row[3], grid->GetNumberOfCells()) || !isIn(row[4], grid->GetNumberOfCells()))
    {
      return false;
    }
    CellComplex::Contact contact;
    std::copy_n(row, 3, contact.Points);
    std::copy_n(row + 3, 2, contact.Cells);
    taken.push_back(contact);
  }
  cells.Contacts = std::move(taken);
  return !cells.Contacts.empty();
}

// Their corners are all that sorting needs: one face each.
void TakeCells(vtkDataSet* grid, vtkIdType first, ImaginaryCells& cells)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = first; cell < grid->GetNumberOfCells(); ++cell)
  {
    grid->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      cells.FaceCorners.push_back(static_cast<int>(ids->GetId(i)));
    }
    cells.FaceOffsets.push_back(static_cast<int>(cells.FaceCorners.size()));
    cells.CellOffsets.push_back(static_cast<int>(cells.FaceOffsets.size()) - 1);
  }
}
}

namespace ImaginaryGrid
{
//------------------------------------------------------------------------------
bool HasImaginaryCells(vtkDataSet* grid)
{
  return FindFirst(grid) < grid->GetNumberOfCells();
}

//------------------------------------------------------------------------------
bool Take(vtkDataSet* grid, CellComplex& complex, ImaginaryCells& cells)
{
  const vtkIdType first = FindFirst(grid);
  auto* contacts =
    vtkIdTypeArray::SafeDownCast(grid->GetFieldData()->GetArray("ImaginaryContacts"));
  if (first == grid->GetNumberOfCells() || !contacts || !AreLast(grid, first) ||
      !TakeContacts(contacts, grid, cells))
  {
    return false;
  }
  TakeCells(grid, first, cells);
  complex.NumberOfCells = static_cast<int>(first);
  complex.Centers.resize(3 * static_cast<size_t>(first));
  return true;
}

//------------------------------------------------------------------------------
void Append(vtkUnstructuredGrid* input, const ImaginaryCells& cells, vtkUnstructuredGrid* output)
{
  const vtkIdType meshCells = input->GetNumberOfCells();
  const vtkIdType more = cells.GetNumberOfCells();
  if (more == 0)
  {
    output->ShallowCopy(input);
  }
  else
  {
    output->DeepCopy(input);
    AppendPoints(input->GetPoints(), cells.Points, output);
    AppendCells(cells, output);
    AppendAttributes(input->GetPointData(), input->GetNumberOfPoints(),
      output->GetNumberOfPoints() - input->GetNumberOfPoints(), output->GetPointData());
    AppendAttributes(input->GetCellData(), meshCells, more, output->GetCellData());
  }
  vtkNew<vtkUnsignedCharArray> marks;
  marks->SetName("Imaginary");
  marks->SetNumberOfValues(meshCells + more);
  std::fill_n(marks->GetPointer(0), meshCells, 0);
  std::fill_n(marks->GetPointer(0) + meshCells, more, 1);
  output->GetCellData()->AddArray(marks);
  output->GetFieldData()->AddArray(MakeContacts(cells));
}

//------------------------------------------------------------------------------
Size Measure(vtkUnstructuredGrid* grid, vtkIdType begin, vtkIdType end)
{
  Size size;
  vtkNew<vtkGenericCell> cell;
  double corners[4][3];
  for (vtkIdType id = begin; id < end; ++id)
  {
    grid->GetCell(id, cell);
    if (cell->GetCellDimension() < 3)
    {
      continue;
    }
    cell->GetPoints()->GetPoint(0, corners[0]);
    size.Faces += cell->GetNumberOfFaces();
    for (int f = 0; f < cell->GetNumberOfFaces(); ++f)
    {
      vtkPoints* face = cell->GetFace(f)->GetPoints();
      face->GetPoint(0, corners[1]);
      for (vtkIdType i = 1; i + 1 < face->GetNumberOfPoints(); ++i)
      {
        face->GetPoint(i, corners[2]);
        face->GetPoint(i + 1, corners[3]);
        size.Volume +=
          std::abs(vtkTetra::ComputeVolume(corners[0], corners[1], corners[2], corners[3]));
      }
    }
  }
  return size;
}
}
