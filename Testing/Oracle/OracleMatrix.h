/**
 * VTK's 4 x 4 matrices as 16 values, row by row.
 */

#ifndef OracleMatrix_h
#define OracleMatrix_h

#include <array>

class vtkMatrix4x4;

namespace OracleMatrix
{
using Values = std::array<double, 16>;

Values Copy(vtkMatrix4x4* source);

/** False where the matrix has no inverse. */
bool Invert(vtkMatrix4x4* source, Values& inverse);
}

#endif
