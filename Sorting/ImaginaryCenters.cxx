#include "ImaginaryCenters.h"

#include "Convexification.h"

namespace ImaginaryCenters
{
//------------------------------------------------------------------------------
std::vector<double> Append(const CellComplex& complex, const ImaginaryCells* imaginary)
{
  std::vector<double> centers = complex.Centers;
  const size_t meshPoints = complex.Points.size() / 3;
  for (int cell = 0; imaginary && cell < imaginary->GetNumberOfCells(); ++cell)
  {
    const int begin = imaginary->FaceOffsets[imaginary->CellOffsets[cell]];
    const int end = imaginary->FaceOffsets[imaginary->CellOffsets[cell + 1]];
    double center[3] = { 0.0, 0.0, 0.0 };
    for (int i = begin; i < end; ++i)
    {
      const size_t point = static_cast<size_t>(imaginary->FaceCorners[i]);
      const double* x = point < meshPoints ? &complex.Points[3 * point]
                                           : &imaginary->Points[3 * (point - meshPoints)];
      for (int k = 0; k < 3; ++k)
      {
        center[k] += x[k] / (end - begin);
      }
    }
    centers.insert(centers.end(), center, center + 3);
  }
  return centers;
}
}
