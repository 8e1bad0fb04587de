// What vtkConvexCellMapper takes as its input, and how far it is with it.

#include "ConvexCellMapperInternals.h"
#include "MapperMessages.h"
#include "vtkConvexCellMapper.h"
#include "vtkInformation.h"

//------------------------------------------------------------------------------
bool vtkConvexCellMapper::CheckInput()
{
  vtkDataObject* input = this->GetDataObjectInput();
  this->Internal->Mesh = input ? this->Internal->Input.Take(input, this) : nullptr;
  const std::string problem = MapperMessages::InputProblem(this->Internal->Mesh);
  if (!this->Internal->Input.GetLeftOut().empty())
  {
    this->WarnOnce(this->Internal->Input.GetLeftOut());
  }
  return this->PassesWithout(problem);
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::Update()
{
  // Without an input VTK's pipeline would repeat its own error several times a frame.
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    this->CheckInput();
    return;
  }
  this->Superclass::Update();
}

//------------------------------------------------------------------------------
int vtkConvexCellMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  this->Superclass::FillInputPortInformation(port, info);
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
double* vtkConvexCellMapper::GetBounds()
{
  if (this->GetDataObjectInput())
  {
    this->Update();
  }
  MapperInput::FindBounds(this->GetDataObjectInput(), this->Bounds);
  return this->Bounds;
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::ReportCells()
{
  // VTK's pipeline says 0 and 1 of its own accord, also where nothing is to be done.
  const double progress = this->Internal->Cells->GetProgress();
  if (progress > 0.0 && progress < 1.0)
  {
    this->ReportPreparation(0.45 * progress);
  }
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::ReportPreparation(double share)
{
  this->Internal->IsPreparing = true;
  this->UpdateProgress(share);
}

//------------------------------------------------------------------------------
void vtkConvexCellMapper::EndPreparation(CellProjectionFrame& frame)
{
  if (this->Internal->IsPreparing)
  {
    this->UpdateProgress(1.0);
    this->Internal->IsPreparing = false;
  }
  // Observers of the progress or of a warning.
  frame.ReturnToWindow();
}
