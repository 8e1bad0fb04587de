/**
 * Where the colour of a point comes from, by VTK's rule for components that depend on each other:
 * of two the first is the scalar of the colour function, of four the first three are the colour
 * (of 0 to 255 in an array of unsigned char); the last is the scalar of the opacity.
 */

#ifndef OracleColors_h
#define OracleColors_h

enum class OracleColors
{
  OfScalar, // that of the opacity too
  OfOwnScalar,
  Direct
};

#endif
