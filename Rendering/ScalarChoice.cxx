#include "ScalarChoice.h"

#include "vtkAbstractMapper.h"
#include "vtkAbstractVolumeMapper.h"
#include "vtkDataArray.h"

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
