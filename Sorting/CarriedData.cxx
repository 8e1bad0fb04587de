#include "CarriedData.h"

#include "vtkAbstractArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>

vtkSmartPointer<vtkDataSetAttributes> CarriedData::WholeArrays(
  vtkDataSetAttributes* from, vtkIdType tuples)
{
  auto whole = vtkSmartPointer<vtkDataSetAttributes>::Take(from->NewInstance());
  whole->ShallowCopy(from);
  for (int i = whole->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (whole->GetAbstractArray(i)->GetNumberOfTuples() != tuples)
    {
      whole->RemoveArray(i);
    }
  }
  return whole;
}

void CarriedData::CopyTuples(vtkDataSetAttributes* from, vtkDataSetAttributes* to,
  const vtkIdType* sources, vtkIdType count, vtkIdType more)
{
  // By chunks, so that the lists stay in cache.
  constexpr vtkIdType chunkSize = 16384;
  if (more > 0)
  {
    to->InterpolateAllocate(from, count + more);
  }
  else
  {
    to->CopyAllOn();
    to->CopyAllocate(from, count);
  }
  vtkNew<vtkIdList> fromIds;
  vtkNew<vtkIdList> toIds;
  for (vtkIdType begin = 0; begin < count && to->GetNumberOfArrays() > 0; begin += chunkSize)
  {
    const vtkIdType size = std::min(chunkSize, count - begin);
    fromIds->SetNumberOfIds(size);
    toIds->SetNumberOfIds(size);
    for (vtkIdType i = 0; i < size; ++i)
    {
      fromIds->SetId(i, sources[begin + i]);
      toIds->SetId(i, begin + i);
    }
    to->CopyData(from, fromIds, toIds);
  }
}
