//VTK::System::Dec
//VTK::Output::Dec

// One tetrahedron in one pixel: entry and exit from the cell's planes, then the exact integral.
// Output: premultiplied colour and alpha, float, to be blended from back to front.

flat in int cell;

//VTK::Ray::Dec
//VTK::Clip::Dec
//VTK::TransferFunction::Dec
//VTK::Integral::Dec
//VTK::Segment::Dec
//VTK::Layer::Dec

void main()
{
  Ray ray = rayOfFragment();
  vec4 texels[6];
  fetchCell(cell, texels);
  Crossing c = crossingOf(texels, ray.point, ray.direction, ray.limits);
  // A flat cell has no height and no volume.
  if (!(c.depth.y > c.depth.x) || c.inverseHeight[0] == 0.0)
  {
    discard;
  }
  //VTK::Layer::Impl
  if (c.depth.y - c.depth.x < 1e-3 * abs(c.depth.x))
  {
    // Depths of a thin cell differ in their last digits: they are taken again from its own place.
    float depth = c.depth.x;
    c = crossingOf(texels, ray.point + depth * ray.direction, ray.direction, ray.limits - depth);
  }
  vec4 cornerScalars = texelFetch(cellScalars, cell);
  float front = scalarAt(c, cornerScalars, c.depth.x);
  float back = scalarAt(c, cornerScalars, c.depth.y);
  float len = max(c.depth.y - c.depth.x, 0.0) * ray.depthToLength;
  gl_FragData[0] = integrateSegment(front, back, len);
}
