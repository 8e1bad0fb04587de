#include "ElementBuffers.h"

#include "FrameStatistics.h"
#include "MeshBlocks.h"
#include "PreparedVolume.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>

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
    // A texture has them: the points' place is taken by one that nobody looks at.
    const std::vector<float> none(1, 0.0f);
    if (!this->Send(
          window, this->Scalars, this->Texture.IsUsed() ? none : prepared.Scalars.Values, 1))
    {
      return false;
    }
    this->ScalarsUploaded.Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
bool ElementBuffers::BeginUpload(
  vtkOpenGLRenderWindow* window, const PreparedVolume& prepared, bool withMesh)
{
  this->OnePerCell = prepared.Scalars.OnePerCell;
  this->UploadedBytes = 0;
  this->UploadSeconds = 0.0;
  this->Failure.clear();
  if (this->Texture.IsUsed() && !this->Texture.Upload(window, prepared, withMesh))
  {
    this->Failure = this->Texture.GetFailure();
    return false;
  }
  return this->FunctionUploaded > prepared.FunctionTime || this->UploadFunction(window, prepared);
}

//------------------------------------------------------------------------------
bool ElementBuffers::Upload(vtkOpenGLRenderWindow* window, const PreparedVolume& prepared)
{
  if (!this->BeginUpload(window, prepared, true))
  {
    return false;
  }
  this->NumberOfBytes = MeshBlocks::CountBytes(
    prepared.Coordinates.Points.size() / 4, prepared.Scalars.Values.size());
  FrameStatistics::Timer timer(this->UploadSeconds);
  return this->UploadMesh(window, prepared);
}

//------------------------------------------------------------------------------
bool ElementBuffers::UploadWithoutMesh(
  vtkOpenGLRenderWindow* window, const PreparedVolume& prepared)
{
  this->PointsUploaded = this->ScalarsUploaded = vtkTimeStamp();
  this->NumberOfBytes = 0;
  return this->BeginUpload(window, prepared, false);
}

//------------------------------------------------------------------------------
bool ElementBuffers::UploadBlock(
  vtkOpenGLRenderWindow* window, const PreparedVolume& prepared, const MeshBlock& block)
{
  FrameStatistics::Timer timer(this->UploadSeconds);
  const std::vector<float>& all = prepared.Scalars.Values;
  std::vector<float> points, scalars;
  for (const int id : block.PointIds)
  {
    const float* point = &prepared.Coordinates.Points[4 * static_cast<size_t>(id)];
    points.insert(points.end(), point, point + 4);
    if (!this->OnePerCell && !this->Texture.IsUsed())
    {
      scalars.push_back(all[id]);
    }
  }
  if (this->OnePerCell)
  {
    scalars.assign(all.begin() + block.Begin, all.begin() + block.End);
  }
  if (this->Texture.IsUsed())
  {
    scalars.assign(1, 0.0f);
    if (!this->Texture.UploadBlock(window, block))
    {
      return false;
    }
  }
  this->NumberOfBytes = std::max(
    this->NumberOfBytes, MeshBlocks::CountBytes(block.PointIds.size(), scalars.size()));
  return this->Send(window, this->Points, points, 4) &&
         this->Send(window, this->Scalars, scalars, 1);
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
  if (this->Texture.IsUsed())
  {
    this->Texture.Activate(program);
  }
  program->SetUniformi("numberOfNodes", this->NumberOfNodes);
  const int scalarKind = this->Texture.IsUsed() ? 2 : this->OnePerCell ? 1 : 0;
  program->SetUniformi("scalarKind", scalarKind);
}

//------------------------------------------------------------------------------
void ElementBuffers::Deactivate()
{
  this->Points.Deactivate();
  this->Scalars.Deactivate();
  this->NodePositions.Deactivate();
  this->NodeValues.Deactivate();
  if (this->Texture.IsUsed())
  {
    this->Texture.Deactivate();
  }
}

//------------------------------------------------------------------------------
void ElementBuffers::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Points.ReleaseGraphicsResources(window);
  this->Scalars.ReleaseGraphicsResources(window);
  this->NodePositions.ReleaseGraphicsResources(window);
  this->NodeValues.ReleaseGraphicsResources(window);
  this->Texture.ReleaseGraphicsResources(window);
  this->PointsUploaded = this->ScalarsUploaded = this->FunctionUploaded = vtkTimeStamp();
}
