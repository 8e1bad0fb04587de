#include "OracleMatrix.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
OracleMatrix::Values OracleMatrix::Copy(vtkMatrix4x4* source)
{
  Values matrix;
  std::copy_n(source->GetData(), 16, matrix.begin());
  return matrix;
}

//------------------------------------------------------------------------------
bool OracleMatrix::Invert(vtkMatrix4x4* source, Values& inverse)
{
  vtkNew<vtkMatrix4x4> result;
  vtkMatrix4x4::Invert(source, result);
  inverse = Copy(result);
  const double determinant = source->Determinant();
  return determinant != 0.0 && std::isfinite(determinant);
}
