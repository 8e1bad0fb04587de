#include "ConvexCellBuffers.h"

#include "PreparedVolume.h"
#include "vtkShaderProgram.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace
{
// Four per piece. Where scalars are those of cells nothing reads them.
std::vector<float> CornerScalars(const ScalarField& scalars, const FacePieces& pieces)
{
  std::vector<float> values(4);
  if (!scalars.OnePerCell)
  {
    values.resize(4 * pieces.Corners.size());
    for (size_t i = 0; i < values.size(); ++i)
    {
      values[i] = scalars.Values[pieces.Corners[i / 4][i % 4]];
    }
  }
  return values;
}
}

//------------------------------------------------------------------------------
void ConvexCellBuffers::Prepare(const PreparedVolume& prepared, const Progress& report)
{
  if (this->CellsTime < prepared.CellsTime)
  {
    this->Cells.Build(prepared.Cells);
    report(0.4);
    this->Pieces.Build(prepared.Coordinates.Points, this->Cells.Loops);
    report(0.7);
    this->Planes.Build(prepared.Coordinates.Points, this->Cells, this->Pieces);
    report(1.0);
    this->CellsTime.Modified();
  }
}

//------------------------------------------------------------------------------
bool ConvexCellBuffers::Upload(vtkOpenGLRenderWindow* window, const PreparedVolume& prepared)
{
  // Stamped where it worked only: the next frame tries again.
  if (this->CellsUploaded < this->CellsTime)
  {
    if (!this->UploadCells(window, prepared))
    {
      return false;
    }
    this->CellsUploaded.Modified();
  }
  if (this->ScalarsUploaded < this->CellsTime || this->ScalarsUploaded < prepared.ScalarsTime)
  {
    if (!this->UploadScalars(window, prepared))
    {
      return false;
    }
    this->ScalarsUploaded.Modified();
  }
  if (this->FunctionUploaded < prepared.FunctionTime)
  {
    if (!this->UploadFunction(window, prepared))
    {
      return false;
    }
    this->FunctionUploaded.Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
template <class Value>
bool ConvexCellBuffers::Put(
  vtkOpenGLRenderWindow* window, Named& named, const Value* values, size_t count, int components)
{
  const bool good = named.Buffer.Upload(window, values, count, components);
  this->Failure = good ? this->Failure : named.Buffer.GetFailure();
  return good;
}

//------------------------------------------------------------------------------
bool ConvexCellBuffers::UploadCells(vtkOpenGLRenderWindow* window, const PreparedVolume& prepared)
{
  const std::vector<int>& corners = this->Cells.Corners.Values;
  const std::vector<float>& points = prepared.Coordinates.Points;
  const CellPlanes& planes = this->Planes;
  return this->Put(window, this->Headers, planes.Headers[0].data(), 4 * planes.Headers.size(), 4) &&
         this->Put(window, this->CornerIds, corners.data(), corners.size(), 1) &&
         this->Put(window, this->Points, points.data(), points.size(), 4) &&
         this->Put(window, this->PlaneTexels, glm::value_ptr(planes.Texels[0]),
           4 * planes.Texels.size(), 4) &&
         this->Put(window, this->PlanePieces, planes.Pieces.data(), planes.Pieces.size(), 1) &&
         this->Put(window, this->PieceCorners, this->Pieces.Corners[0].data(),
           4 * this->Pieces.Corners.size(), 4) &&
         this->Put(window, this->PieceShapes, glm::value_ptr(this->Pieces.Shapes[0].GradientU),
           12 * this->Pieces.Shapes.size(), 4);
}

//------------------------------------------------------------------------------
bool ConvexCellBuffers::UploadScalars(vtkOpenGLRenderWindow* window, const PreparedVolume& prepared)
{
  const ScalarField& scalars = prepared.Scalars;
  this->OnePerCell = scalars.OnePerCell;
  const std::vector<float> corners = CornerScalars(scalars, this->Pieces);
  const size_t cells = scalars.OnePerCell ? scalars.Values.size() : 1;
  return this->Put(window, this->PieceScalars, corners.data(), corners.size(), 4) &&
         this->Put(window, this->CellValues, scalars.Values.data(), cells, 1);
}

//------------------------------------------------------------------------------
bool ConvexCellBuffers::UploadFunction(
  vtkOpenGLRenderWindow* window, const PreparedVolume& prepared)
{
  const std::vector<float>& positions = prepared.Function.GetPositions();
  const std::vector<float>& values = prepared.Function.GetValues();
  this->NumberOfNodes = prepared.Function.GetNumberOfNodes();
  return this->Put(window, this->NodePositions, positions.data(), positions.size(), 1) &&
         this->Put(window, this->NodeValues, values.data(), values.size(), 4);
}

//------------------------------------------------------------------------------
std::array<ConvexCellBuffers::Named*, 11> ConvexCellBuffers::GetAll()
{
  return { { &this->Headers, &this->CornerIds, &this->Points, &this->PlaneTexels,
    &this->PlanePieces, &this->PieceCorners, &this->PieceShapes, &this->PieceScalars,
    &this->CellValues, &this->NodePositions, &this->NodeValues } };
}

//------------------------------------------------------------------------------
void ConvexCellBuffers::Activate(vtkShaderProgram* program)
{
  for (Named* named : this->GetAll())
  {
    named->Buffer.Activate(program, named->Sampler);
  }
  program->SetUniformi("numberOfNodes", this->NumberOfNodes);
  program->SetUniformi("onePerCell", this->OnePerCell ? 1 : 0);
}

//------------------------------------------------------------------------------
void ConvexCellBuffers::Deactivate()
{
  for (Named* named : this->GetAll())
  {
    named->Buffer.Deactivate();
  }
}

//------------------------------------------------------------------------------
void ConvexCellBuffers::ReleaseGraphicsResources(vtkWindow* window)
{
  for (Named* named : this->GetAll())
  {
    named->Buffer.ReleaseGraphicsResources(window);
  }
  this->CellsUploaded = vtkTimeStamp();
  this->ScalarsUploaded = vtkTimeStamp();
  this->FunctionUploaded = vtkTimeStamp();
}
