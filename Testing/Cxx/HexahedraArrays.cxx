#include "HexahedraArrays.h"

#include "MeshLattice.h"
#include "vtkUnstructuredGrid.h"

#include <numeric>

//------------------------------------------------------------------------------
HexahedraArrays::HexahedraArrays(int n, const std::function<void(float* point)>& move)
{
  const MeshLattice::Grid grid = MeshLattice(n, n, n).Make();
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    double point[3];
    grid->GetPoint(id, point);
    for (const double x : point)
    {
      this->Points.push_back(static_cast<float>(2.0 * x / n - 1.0));
    }
    this->Points.push_back(0.0f);
    if (move)
    {
      move(&this->Points[this->Points.size() - 4]);
    }
    this->Scalars.push_back(static_cast<float>((point[0] + point[1] * point[2] / n) / (2.0 * n)));
  }
  this->Cells.Build(grid);
  this->Pieces.Build(this->Points, this->Cells.Loops);
  this->Planes.Build(this->Points, this->Cells, this->Pieces);
  this->Drawn.resize(static_cast<std::size_t>(this->Cells.GetNumberOfCells()));
  std::iota(this->Drawn.begin(), this->Drawn.end(), 0u);
}
