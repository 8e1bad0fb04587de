/**
 * The cells of a data set as a complex.
 *
 * Cells of dimension 0 to 2, cells that are not linear, cells whose `Imaginary` array says 1, and
 * cells with ids that do not exist or points that are not finite have no faces; they keep their
 * place in the numbering. Points at the very same coordinates count as the one of smallest id.
 */
#ifndef CellComplexReader_h
#define CellComplexReader_h

class vtkDataSet;
struct CellComplex;

namespace CellComplexReader
{
void Read(vtkDataSet* input, CellComplex& complex);
}

#endif
