#include "vtkPowerVisibilitySort.h"

#include "CellComplex.h"
#include "Convexification.h"
#include "DelaunayTest.h"
#include "MeshTime.h"
#include "PowerCells.h"

#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkObjectFactory.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"

vtkStandardNewMacro(vtkPowerVisibilitySort);

namespace
{
void ReadCorners(vtkDataSet* input, vtkIdType cell, vtkIdList* ids, std::vector<double>& corners)
{
  input->GetCellPoints(cell, ids);
  corners.resize(3 * static_cast<std::size_t>(ids->GetNumberOfIds()));
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    input->GetPoint(ids->GetId(i), corners.data() + 3 * i);
  }
}
}

class vtkPowerVisibilitySort::Internals
{
public:
  std::vector<vtkIdType> Order;

  /** Forgets everything where the mesh has changed. */
  void Follow(vtkDataSet* input)
  {
    const MeshTime time = MeshTimeOf(input);
    if (input != this->Input || time != this->SeenTime)
    {
      this->Input = input;
      this->SeenTime = time;
      this->HasCells = false;
      this->NumberOfIrregularFaces = -1;
    }
  }

  PowerCells& GetCells()
  {
    if (!this->HasCells)
    {
      this->ReadCells();
      this->HasCells = true;
    }
    return this->Cells;
  }

  vtkIdType CountIrregularFaces(const CellComplex& complex);

  vtkDataSet* Input = nullptr; // compared, and used while it is the sort's input
  MeshTime SeenTime{};
  vtkIdType NumberOfIrregularFaces = -1; // negative: not known yet

private:
  void ReadCells();

  PowerCells Cells;
  bool HasCells = false;
  vtkSMPThreadLocalObject<vtkIdList> Ids;
};

//------------------------------------------------------------------------------
void vtkPowerVisibilitySort::Internals::ReadCells()
{
  double bounds[6];
  this->Input->GetBounds(bounds);
  const vtkIdType count = this->Input->GetNumberOfCells();
  this->Cells.Initialize(count, bounds);
  if (count > 0)
  {
    // VTK's read access is safe from all threads after a first call from one.
    vtkNew<vtkIdList> ids;
    this->Input->GetCellPoints(0, ids);
  }
  vtkSMPTools::For(0, count,
    [this](vtkIdType begin, vtkIdType end)
    {
      std::vector<double> corners;
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        ReadCorners(this->Input, cell, this->Ids.Local(), corners);
        this->Cells.SetCell(cell, corners.data(), static_cast<int>(corners.size() / 3));
      }
    });
}

//------------------------------------------------------------------------------
vtkIdType vtkPowerVisibilitySort::Internals::CountIrregularFaces(const CellComplex& complex)
{
  const PowerCells& cells = this->GetCells();
  return DelaunayTest::CountIrregularContacts(
    complex,
    [this](int cell, std::vector<double>& corners)
    { ReadCorners(this->Input, cell, this->Ids.Local(), corners); },
    [&cells](int cell) { return cells.IsCospherical(cell); });
}

//------------------------------------------------------------------------------
vtkPowerVisibilitySort::vtkPowerVisibilitySort()
  : Internal(new Internals)
{
}

vtkPowerVisibilitySort::~vtkPowerVisibilitySort() = default;

//------------------------------------------------------------------------------
const std::vector<vtkIdType>& vtkPowerVisibilitySort::SortCells(const double eye[4])
{
  this->Internal->Follow(this->Input);
  this->Internal->GetCells().SortBackToFront(eye, this->Internal->Order);
  return this->Internal->Order;
}

//------------------------------------------------------------------------------
vtkIdType vtkPowerVisibilitySort::GetNumberOfIrregularFaces()
{
  if (!this->Input)
  {
    return 0;
  }
  this->Internal->Follow(this->Input);
  vtkIdType& count = this->Internal->NumberOfIrregularFaces;
  if (count < 0)
  {
    count = this->Internal->CountIrregularFaces(this->GetComplex());
  }
  return count;
}

//------------------------------------------------------------------------------
bool vtkPowerVisibilitySort::IsExact()
{
  return this->Input && this->GetNumberOfIrregularFaces() == 0 && this->IsComplexConvex() &&
         this->GetImaginaryCells().GetNumberOfCells() == 0;
}

//------------------------------------------------------------------------------
void vtkPowerVisibilitySort::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfIrregularFaces: ";
  if (this->Internal->NumberOfIrregularFaces < 0)
  {
    os << "(not counted yet)\n";
  }
  else
  {
    os << this->Internal->NumberOfIrregularFaces << "\n";
  }
}
