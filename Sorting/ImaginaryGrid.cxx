#include "ImaginaryGrid.h"

#include "Convexification.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

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

void AppendCells(const ImaginaryCells& cells, vtkUnstructuredGrid* output)
{
  vtkNew<vtkIdList> stream;
  for (int cell = 0; cell < cells.GetNumberOfCells(); ++cell)
  {
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
}

namespace ImaginaryGrid
{
//------------------------------------------------------------------------------
bool HasImaginaryCells(vtkUnstructuredGrid* grid)
{
  auto* marks = vtkUnsignedCharArray::SafeDownCast(grid->GetCellData()->GetArray("Imaginary"));
  if (!marks || marks->GetNumberOfTuples() != grid->GetNumberOfCells())
  {
    return false;
  }
  const unsigned char* begin = marks->GetPointer(0);
  return std::find(begin, begin + marks->GetNumberOfTuples(), 1) !=
         begin + marks->GetNumberOfTuples();
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
}
