//VTK::System::Dec
//VTK::Output::Dec

// The greatest, or least, scalar of one convex cell in one pixel: it lies at one of its ends, which
// may be cut by the near plane, a clipping plane or opaque geometry.

flat in int cell;

uniform int findLeast;
uniform int onlyBeforeOpaque; // draw where opaque geometry cuts the cell

//VTK::Ray::Dec
//VTK::ConvexCell::Dec
//VTK::CellScalars::Dec

void main()
{
  Ray ray = rayOfFragment();
  if (onlyBeforeOpaque != 0 && texelFetch(opaqueDepth, ivec2(gl_FragCoord.xy), 0).r >= 1.0)
  {
    discard;
  }
  Passage p = passageOf(cell, ray);
  vec2 scalars;
  if (!scalarsAlong(cell, ray, p, scalars))
  {
    discard;
  }
  gl_FragData[0] =
    vec4(findLeast != 0 ? min(scalars.x, scalars.y) : max(scalars.x, scalars.y));
}
