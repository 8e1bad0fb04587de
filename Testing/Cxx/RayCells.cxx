#include "RayCells.h"

#include "vtkCell.h"
#include "vtkIdList.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

//------------------------------------------------------------------------------
RayCells::RayCells(vtkUnstructuredGrid* grid, const std::vector<bool>& skipped)
{
  std::map<Point, vtkIdType> known;
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    Point p;
    grid->GetPoint(id, p.data());
    this->Points.push_back(p);
    this->Merged.push_back(known.emplace(p, id).first->second);
  }
  this->ReadCells(grid, skipped);
  this->MakeBoxes();
}

//------------------------------------------------------------------------------
void RayCells::ReadCells(vtkUnstructuredGrid* grid, const std::vector<bool>& skipped)
{
  this->Offsets.push_back(0);
  this->CornerOffsets.push_back(0);
  std::vector<vtkIdType> corners;
  for (vtkIdType id = 0; id < grid->GetNumberOfCells(); ++id)
  {
    vtkCell* cell = grid->GetCell(id);
    if (cell->GetCellDimension() != 3 || (!skipped.empty() && skipped[id]))
    {
      continue;
    }
    for (int face = 0; face < cell->GetNumberOfFaces(); ++face)
    {
      vtkIdList* ids = cell->GetFace(face)->GetPointIds();
      corners.assign(ids->begin(), ids->end());
      if (cell->GetFace(face)->GetCellType() == VTK_PIXEL)
      {
        std::swap(corners[2], corners[3]);
      }
      this->AddFace(corners);
    }
    this->AddCorners();
    this->Offsets.push_back(static_cast<int>(this->Triangles.size()));
    this->CellIds.push_back(id);
  }
}

//------------------------------------------------------------------------------
void RayCells::AddFace(const std::vector<vtkIdType>& corners)
{
  std::vector<vtkIdType> ids;
  for (const vtkIdType corner : corners)
  {
    if (ids.empty() || this->Merged[corner] != ids.back())
    {
      ids.push_back(this->Merged[corner]);
    }
  }
  std::rotate(ids.begin(), std::min_element(ids.begin(), ids.end()), ids.end());
  for (std::size_t i = 2; i < ids.size(); ++i)
  {
    std::array<vtkIdType, 3> triangle = { { ids[0], ids[i - 1], ids[i] } };
    std::sort(triangle.begin(), triangle.end());
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2])
    {
      this->Triangles.push_back(triangle);
    }
  }
}

//------------------------------------------------------------------------------
void RayCells::AddCorners()
{
  const auto begin = this->Triangles.begin() + this->Offsets.back();
  std::vector<vtkIdType> ids;
  std::for_each(begin, this->Triangles.end(),
    [&](const auto& triangle) { ids.insert(ids.end(), triangle.begin(), triangle.end()); });
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::for_each(begin, this->Triangles.end(),
    [&](const auto& triangle)
    {
      std::array<int, 3> places;
      std::transform(triangle.begin(), triangle.end(), places.begin(),
        [&](vtkIdType id) { return std::lower_bound(ids.begin(), ids.end(), id) - ids.begin(); });
      this->Places.push_back(places);
    });
  std::transform(ids.begin(), ids.end(), std::back_inserter(this->Corners),
    [this](vtkIdType id) { return this->Points[id]; });
  this->CornerOffsets.push_back(static_cast<int>(this->Corners.size()));
}

//------------------------------------------------------------------------------
void RayCells::MakeBoxes()
{
  BoxTree::Box all;
  for (std::size_t cell = 0; cell < this->CellIds.size(); ++cell)
  {
    BoxTree::Box box;
    for (int at = this->Offsets[cell]; at < this->Offsets[cell + 1]; ++at)
    {
      for (const vtkIdType id : this->Triangles[at])
      {
        box.Add(this->Points[id].data());
        all.Add(this->Points[id].data());
      }
    }
    this->Boxes.push_back(box);
  }
  this->Diagonal = std::hypot(
    std::hypot(all.High[0] - all.Low[0], all.High[1] - all.Low[1]), all.High[2] - all.Low[2]);
}
