#include "ElementBuffers.h"

#include "FrameStatistics.h"
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
bool ElementBuffers::Send(vtkOpenGLRenderWindow* window, TextureBuffer& buffer,
  const std::vector<float>& values, int components)
{
  this->UploadedBytes += sizeof(float) * values.size();
  return this->Check(buffer, buffer.Upload(window, values, components));
}

//------------------------------------------------------------------------------
bool ElementBuffers::UploadMesh(vtkOpenGLRenderWindow* window, const PreparedVolume& prepared)
{
  // Stamped where it worked only: the next frame tries again.
  if (this->PointsUploaded < prepared.PointsTime)
  {
    if (!this->Send(window, this->Points, prepared.Coordinates.Points, 4))
    {
      return false;
    }
    this->PointsUploaded.Modified();
  }
  if (this->ScalarsUploaded < prepared.ScalarsTime)
  {
    if (!this->Send(window, this->Scalars, prepared.Scalars.Values, 1))
    {
      return false;
    }
    this->ScalarsUploaded.Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
bool ElementBuffers::Upload(vtkOpenGLRenderWindow* window, const PreparedVolume& prepared)
{
  this->OnePerCell = prepared.Scalars.OnePerCell;
  this->NumberOfBytes =
    sizeof(float) * (prepared.Coordinates.Points.size() + prepared.Scalars.Values.size());
  this->UploadedBytes = 0;
  this->UploadSeconds = 0.0;
  FrameStatistics::Timer timer(this->UploadSeconds);
  return this->UploadMesh(window, prepared) &&
         (this->FunctionUploaded > prepared.FunctionTime || this->UploadFunction(window, prepared));
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
