/**
 * Where cells are, imaginary ones included.
 */
#ifndef ImaginaryCenters_h
#define ImaginaryCenters_h

#include <vector>

struct CellComplex;
struct ImaginaryCells;

namespace ImaginaryCenters
{
/** The centres of the complex's cells, then the means of the corners of the imaginary ones; three
 *  per cell. `imaginary` may be null. */
std::vector<double> Append(const CellComplex& complex, const ImaginaryCells* imaginary);
}

#endif
