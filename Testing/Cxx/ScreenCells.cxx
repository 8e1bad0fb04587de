#include "ScreenCells.h"

#include "TransferFunction.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <numeric>

//------------------------------------------------------------------------------
ScreenCells::ScreenCells(const std::vector<float>& corners, bool isCut)
{
  this->SetMesh(corners);
  this->SetTransfer(isCut);
  // So deep that floats are trusted wherever they are numbers.
  this->View.Extent = 1e6;
  this->View.NearU = 1e6;
  this->View.FarU = -1e6;
  this->View.Width = this->View.Height = 2 * TileSize::Pixels;
  this->Task.Mesh = &this->Mesh;
  this->Task.View = &this->View;
  this->Task.Vertices = &this->Vertices;
  this->Task.Cells = &this->Cells;
  this->Task.Transfer = &this->Transfer;
  this->Task.OpticalDepth = 1e-6;
}

//------------------------------------------------------------------------------
void ScreenCells::SetMesh(const std::vector<float>& corners)
{
  const std::size_t count = corners.size() / 16;
  this->Vertices.Values = this->Mesh.Points = corners;
  this->Mesh.Corners.resize(4 * count);
  std::iota(this->Mesh.Corners.begin(), this->Mesh.Corners.end(), 0);
  this->Mesh.Steps.assign(count, 0);
  this->Cells.Faces.assign(count, 0);
  for (std::size_t cell = 0; cell < count; ++cell)
  {
    glm::dvec3 p[4];
    for (std::size_t i = 0; i < 4; ++i)
    {
      p[i] = glm::dvec3(glm::make_vec3(&corners[16 * cell + 4 * i]));
    }
    const double volume = glm::dot(p[3] - p[0], glm::cross(p[1] - p[0], p[2] - p[0]));
    this->Mesh.Orientations.push_back(static_cast<signed char>((volume > 0.0) - (volume < 0.0)));
  }
}

//------------------------------------------------------------------------------
void ScreenCells::SetTransfer(bool isCut)
{
  const std::vector<double> nodes = { 0.0, 0.3, 0.4, 0.6, 0.7, 1.0 };
  const double range[2] = { 0.0, 1.0 };
  TransferFunction function;
  function.Build(nodes,
    [isCut](double x)
    { return TransferFunction::Sample{ { x, 0.5, 0.5, isCut && (x < 0.35 || x > 0.65) ? 0.0 : 0.5 } }; },
    range, range, 1.0);
  this->Transfer.Build(function, 1.0);
}

//------------------------------------------------------------------------------
void ScreenCells::MakeExact(int step)
{
  for (std::size_t cell = 0; step > 0 && cell < this->Cells.Faces.size(); cell += static_cast<std::size_t>(step))
  {
    this->Cells.Faces[cell] |= TileCells::Exact;
  }
}

//------------------------------------------------------------------------------
std::vector<TileRectangle> ScreenCells::MakeRectangles()
{
  std::vector<TileRectangle> rectangles = { TileRectangle::OfTile(0, 64, 64), TileRectangle::OfTile(0, 33, 17),
    TileRectangle::OfTile(3, 100, 128) };
  const std::array<int, 4> boxes[] = { { 3, 5, 60, 47 }, { 31, 0, 31, 63 }, { 0, 20, 63, 20 }, { 30, 30, 30, 30 } };
  for (const auto& box : boxes)
  {
    TileRectangle part = rectangles[0];
    part.FirstX = box[0];
    part.FirstY = box[1];
    part.LastX = box[2];
    part.LastY = box[3];
    rectangles.push_back(part);
  }
  return rectangles;
}
