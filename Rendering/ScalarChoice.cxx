#include "ScalarChoice.h"

#include "vtkAbstractMapper.h"
#include "vtkAbstractVolumeMapper.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

//------------------------------------------------------------------------------
ScalarChoice::ScalarChoice(vtkAbstractVolumeMapper* mapper, vtkDataSet* data)
{
  int cellFlag = 0;
  this->Array = vtkAbstractMapper::GetScalars(data, mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cellFlag);
  this->OnePerCell = cellFlag == 1;
  // Field data (flag 2) belong to no point and no cell.
  if (cellFlag > 1)
  {
    this->Array = nullptr;
  }
  if (!this->Array)
  {
    this->Describe(mapper);
    return;
  }
  const vtkIdType tuples = this->Array->GetNumberOfTuples();
  const vtkIdType expected =
    this->OnePerCell ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  if (tuples != expected)
  {
    const std::string name = this->Array->GetName() ? this->Array->GetName() : "(without a name)";
    this->Problem = "array " + name + " has " + std::to_string(tuples) + " tuples for " +
                    std::to_string(expected) + (this->OnePerCell ? " cells" : " points") +
                    "; it must have one for each.";
    this->Array = nullptr;
  }
}

//------------------------------------------------------------------------------
void ScalarChoice::Describe(vtkAbstractVolumeMapper* mapper)
{
  const int mode = mapper->GetScalarMode();
  const bool ofCells = mode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA;
  if (!ofCells && mode != VTK_SCALAR_MODE_USE_POINT_FIELD_DATA)
  {
    this->Problem = std::string("the input has no active scalars for scalar mode ") +
                    mapper->GetScalarModeAsString() + "; set them or call SelectScalarArray.";
    return;
  }
  std::string name = "number " + std::to_string(mapper->GetArrayId());
  if (mapper->GetArrayAccessMode() == VTK_GET_ARRAY_BY_NAME)
  {
    name = mapper->GetArrayName() ? mapper->GetArrayName() : "(null)";
  }
  this->Problem = std::string("the ") + (ofCells ? "cell" : "point") +
                  " data of the input have no array " + name +
                  "; call SelectScalarArray with one they have.";
}

//------------------------------------------------------------------------------
vtkDataArray* ScalarChoice::FindIn(vtkDataSet* made, vtkAbstractVolumeMapper* mapper) const
{
  const char* name = this->Array ? this->Array->GetName() : nullptr;
  if (!name)
  {
    return ScalarChoice(mapper, made).Array;
  }
  // By name: numbers move where an array of the wrong length was left behind.
  return this->OnePerCell ? made->GetCellData()->GetArray(name)
                          : made->GetPointData()->GetArray(name);
}
