#include "ElementBuffers.h"

#include "PreparedVolume.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
bool ElementBuffers::Check(const TextureBuffer& buffer, bool uploaded)
{
  if (!uploaded)
  {
    this->Failure = buffer.GetFailure();
  }
  return uploaded;
}

//------------------------------------------------------------------------------
bool ElementBuffers::Upload(vtkOpenGLRenderWindow* window, const PreparedVolume& prepared)
{
  const std::vector<float>& points = prepared.Coordinates.Points;
  const std::vector<float>& scalars = prepared.Scalars.Values;
  this->OnePerCell = prepared.Scalars.OnePerCell;
  this->NumberOfBytes = sizeof(float) * (points.size() + scalars.size());
  // Stamped where it worked only: the next frame tries again.
  if (this->PointsUploaded < prepared.PointsTime)
  {
    if (!this->Check(this->Points, this->Points.Upload(window, points, 4)))
    {
      return false;
    }
    this->PointsUploaded.Modified();
  }
  if (this->ScalarsUploaded < prepared.ScalarsTime)
  {
    if (!this->Check(this->Scalars, this->Scalars.Upload(window, scalars, 1)))
    {
      return false;
    }
    this->ScalarsUploaded.Modified();
  }
  return this->FunctionUploaded > prepared.FunctionTime || this->UploadFunction(window, prepared);
}

//------------------------------------------------------------------------------
bool ElementBuffers::UploadFunction(vtkOpenGLRenderWindow* window, const PreparedVolume& prepared)
{
  const TransferFunction& function = prepared.Function;
  this->NumberOfNodes = function.GetNumberOfNodes();
  const bool good =
    this->Check(
      this->NodePositions, this->NodePositions.Upload(window, function.GetPositions(), 1)) &&
    this->Check(this->NodeValues, this->NodeValues.Upload(window, function.GetValues(), 4));
  if (good)
  {
    this->FunctionUploaded.Modified();
  }
  return good;
}

//------------------------------------------------------------------------------
void ElementBuffers::Activate(vtkShaderProgram* program)
{
  this->Points.Activate(program, "points");
  this->Scalars.Activate(program, "scalars");
  this->NodePositions.Activate(program, "nodePositions");
  this->NodeValues.Activate(program, "nodeValues");
  program->SetUniformi("numberOfNodes", this->NumberOfNodes);
  program->SetUniformi("onePerCell", this->OnePerCell ? 1 : 0);
}

//------------------------------------------------------------------------------
void ElementBuffers::Deactivate()
{
  this->Points.Deactivate();
  this->Scalars.Deactivate();
  this->NodePositions.Deactivate();
  this->NodeValues.Deactivate();
}

//------------------------------------------------------------------------------
void ElementBuffers::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Points.ReleaseGraphicsResources(window);
  this->Scalars.ReleaseGraphicsResources(window);
  this->NodePositions.ReleaseGraphicsResources(window);
  this->NodeValues.ReleaseGraphicsResources(window);
  this->PointsUploaded = this->ScalarsUploaded = this->FunctionUploaded = vtkTimeStamp();
}
