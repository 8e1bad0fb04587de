//VTK::System::Dec
//VTK::Output::Dec

// One convex cell in one pixel: entry and exit from the cell's planes, then the emission between.
// Output: colour, to be added to what other cells give; alpha 0.

flat in int cell;

uniform int averageEmission;

//VTK::Ray::Dec
//VTK::ConvexCell::Dec
//VTK::CellScalars::Dec
//VTK::TransferFunction::Dec
//VTK::Integral::Dec
//VTK::Segment::Dec

vec3 emissionAt(float scalar)
{
  vec4 value = valueInInterval(firstInterval(scalar, false), scalar);
  return value.a * value.rgb;
}

void main()
{
  Ray ray = rayOfFragment();
  Passage p = passageOf(cell, ray);
  vec2 scalars;
  if (!scalarsAlong(cell, ray, p, scalars))
  {
    discard;
  }
  float len = (p.depths.y - p.depths.x) * ray.depthToLength;
  vec3 colour = averageEmission != 0
    ? 0.5 * len * (emissionAt(scalars.x) + emissionAt(scalars.y))
    : integrateSegment(scalars.x, scalars.y, len).rgb;
  gl_FragData[0] = vec4(colour, 0.0);
}
