#include "ConvexCellReader.h"

#include "ConvexCellPoints.h"
#include "CurvedCell.h"
#include "PointSetFaces.h"
#include "PolyhedronSurface.h"
#include "VTKVersions.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <utility>

namespace
{
using TetrahedralSplit::Shape;

// Null where there is none that fits.
const unsigned char* Bytes(vtkDataSetAttributes* data, const char* name, vtkIdType count)
{
  auto* array = vtkUnsignedCharArray::SafeDownCast(data->GetArray(name));
  const bool fits = array && array->GetNumberOfValues() == count;
  return fits && count > 0 ? array->GetPointer(0) : nullptr;
}

// Of any implementation: as GetFaceStream, which only vtkUnstructuredGrid has.
void ListFaces(vtkCell* cell, vtkIdList* stream)
{
  stream->Reset();
  stream->InsertNextId(cell->GetNumberOfFaces());
  for (int index = 0; index < cell->GetNumberOfFaces(); ++index)
  {
    vtkIdList* ids = cell->GetFace(index)->GetPointIds();
    stream->InsertNextId(ids->GetNumberOfIds());
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      stream->InsertNextId(ids->GetId(i));
    }
  }
}
}

ConvexCellReader::ConvexCellReader(vtkUnstructuredGridBase* input)
  : Input(input)
  , GhostCells(Bytes(
      input->GetCellData(), vtkDataSetAttributes::GhostArrayName(), input->GetNumberOfCells()))
  , ImaginaryCells(Bytes(input->GetCellData(), "Imaginary", input->GetNumberOfCells()))
{
}

ConvexCellReader::~ConvexCellReader() = default;

void ConvexCellReader::Open()
{
  const vtkIdType count = this->Input->GetNumberOfCells();
  this->Types.resize(count);
  this->Grid = vtkUnstructuredGrid::SafeDownCast(this->Input);
  if (!this->Grid)
  {
    this->CopyCells();
  }
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        this->Types[cell] = static_cast<unsigned char>(this->Grid->GetCellType(cell));
      }
    });
}

// Other implementations promise nothing to threads.
void ConvexCellReader::CopyCells()
{
  this->Grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  this->Grid->Allocate(this->Input->GetNumberOfCells());
  vtkNew<vtkIdList> list;
  vtkNew<vtkGenericCell> generic;
  for (vtkIdType cell = 0; cell < this->Input->GetNumberOfCells(); ++cell)
  {
    const int type = this->Input->GetCellType(cell);
    if (type == VTK_POLYHEDRON)
    {
      this->Input->GetCell(cell, generic);
      ListFaces(generic, list);
    }
    else
    {
      this->Input->GetCellPoints(cell, list);
    }
    this->Grid->InsertNextCell(type, list);
  }
  this->Grid->SetPoints(this->Input->GetPoints());
  this->Grid->GetPointData()->ShallowCopy(this->Input->GetPointData());
  this->Grid->GetCellData()->ShallowCopy(this->Input->GetCellData());
}

void ConvexCellReader::Close()
{
  // What cannot be read by threads cannot be read again.
  this->Grid = this->Grid == this->Input ? nullptr : this->Grid.Get();
  this->Input = nullptr;
}

bool ConvexCellReader::HasSameTypes(vtkUnstructuredGridBase* input) const
{
  const auto count = static_cast<vtkIdType>(this->Types.size());
  bool same = input->GetNumberOfCells() == count;
  auto* grid = vtkUnstructuredGrid::SafeDownCast(input);
  vtkUnsignedCharArray* types = grid ? GetTypesOfCells(grid) : nullptr;
  if (same && types && types->GetNumberOfValues() == count)
  {
    return std::equal(this->Types.begin(), this->Types.end(), types->GetPointer(0));
  }
  for (vtkIdType cell = 0; same && cell < count; ++cell)
  {
    same = this->Types[cell] == static_cast<unsigned char>(input->GetCellType(cell));
  }
  return same;
}

ConvexCellPlan::FateType ConvexCellReader::Refuse(vtkIdType cell) const
{
  if (this->ImaginaryCells && this->ImaginaryCells[cell] == 1)
  {
    return ConvexCellPlan::Imaginary;
  }
  const int bits = this->GhostCells ? this->GhostCells[cell] : 0;
  return bits & vtkDataSetAttributes::DUPLICATECELL ? ConvexCellPlan::Ghost
         : bits & vtkDataSetAttributes::HIDDENCELL  ? ConvexCellPlan::Hidden
                                                    : ConvexCellPlan::Whole;
}

bool ConvexCellReader::ShapeOf(int cellType, Shape& shape)
{
  if (CurvedCell::TwinOf(cellType, shape))
  {
    return true;
  }
  switch (cellType)
  {
    case VTK_TETRA:
      shape = Shape::Tetrahedron;
      return true;
    case VTK_PYRAMID:
      shape = Shape::Pyramid;
      return true;
    case VTK_WEDGE:
      shape = Shape::Wedge;
      return true;
    case VTK_VOXEL:
    case VTK_HEXAHEDRON:
      shape = Shape::Hexahedron;
      return true;
    case VTK_PENTAGONAL_PRISM:
      shape = Shape::PentagonalPrism;
      return true;
    case VTK_HEXAGONAL_PRISM:
      shape = Shape::HexagonalPrism;
      return true;
    default:
      return false;
  }
}

// In place where the mesh has its lists as vtkIdType, else by way of `list`.
void ConvexCellReader::ReadList(
  vtkIdType cell, vtkIdList* list, vtkIdType& size, const vtkIdType*& ids) const
{
  vtkCellArray* cells = this->Grid->GetCells();
  if (cells->IsStorageShareable())
  {
    cells->GetCellAtId(cell, size, ids);
    return;
  }
  cells->GetCellAtId(cell, list);
  size = list->GetNumberOfIds();
  ids = list->GetPointer(0);
}

bool ConvexCellReader::ReadIds(vtkIdType cell, Shape shape, const std::vector<vtkIdType>& canonical,
  vtkIdList* list, vtkIdType* ids) const
{
  const int count = TetrahedralSplit::NumberOfVertices(shape);
  Shape twin;
  const int type = this->Types[cell];
  vtkIdType size;
  const vtkIdType* listed;
  this->ReadList(cell, list, size, listed);
  const vtkIdType more = size - count;
  if (more < 0 || (more > 0 && !CurvedCell::TwinOf(type, twin)))
  {
    return false;
  }
  for (int i = 0; i < count; ++i)
  {
    const vtkIdType id = listed[i];
    if (id < 0 || id >= static_cast<vtkIdType>(canonical.size()))
    {
      return false;
    }
    ids[i] = canonical[id];
  }
  if (type == VTK_VOXEL)
  {
    std::swap(ids[2], ids[3]);
    std::swap(ids[6], ids[7]);
  }
  return true;
}

bool ConvexCellReader::ReadAllIds(vtkIdType cell, const std::vector<vtkIdType>& canonical,
  vtkIdList* list, std::vector<vtkIdType>& ids) const
{
  this->Grid->GetCells()->GetCellAtId(cell, list);
  ids.assign(list->begin(), list->end());
  for (vtkIdType& id : ids)
  {
    if (id < 0 || id >= static_cast<vtkIdType>(canonical.size()))
    {
      return false;
    }
    id = canonical[id];
  }
  return true;
}

ConvexCellPlan::FateType ConvexCellReader::ReadSurface(vtkIdType cell,
  const ConvexCellPoints& points, vtkIdList* list, PolyhedronSurface& surface) const
{
  const std::vector<vtkIdType>& canonical = points.GetCanonical();
  auto otherwise = ConvexCellPlan::WrongList;
  if (this->Types[cell] == VTK_CONVEX_POINT_SET)
  {
    const ConvexCellPlan::FateType fate = this->ListHull(cell, points, list);
    if (fate != ConvexCellPlan::Whole)
    {
      return fate;
    }
    otherwise = ConvexCellPlan::ZeroVolume;
  }
  else if (HasFaceStream(this->Grid, cell, list))
  {
    this->Grid->GetFaceStream(cell, list);
  }
  else
  {
    return otherwise;
  }
  const std::vector<vtkIdType>& ids = surface.GetIds();
  return surface.Read(list->GetPointer(0), list->GetNumberOfIds(), canonical.data(),
           static_cast<vtkIdType>(canonical.size()))
           ? ConvexCellPoints::FateOf(ids.data(), static_cast<vtkIdType>(ids.size()))
           : otherwise;
}

ConvexCellPlan::FateType ConvexCellReader::ListHull(
  vtkIdType cell, const ConvexCellPoints& points, vtkIdList* list) const
{
  std::vector<vtkIdType> ids;
  if (!this->ReadAllIds(cell, points.GetCanonical(), list, ids))
  {
    return ConvexCellPlan::Invalid;
  }
  const auto fate = ConvexCellPoints::FateOf(ids.data(), static_cast<vtkIdType>(ids.size()));
  if (fate != ConvexCellPlan::Whole)
  {
    return fate;
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<double> coordinates(3 * ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    points.Get(ids[i], &coordinates[3 * i]);
  }
  // Exact signs are exact as long as no product underflows.
  TetrahedralSplit::ScaleIfExtreme(
    reinterpret_cast<double(*)[3]>(coordinates.data()), static_cast<int>(ids.size()));
  PointSetFaces::List(ids, coordinates, list);
  return ConvexCellPlan::Whole;
}
