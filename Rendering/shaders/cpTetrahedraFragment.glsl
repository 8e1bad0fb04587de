//VTK::System::Dec
//VTK::Output::Dec

// One tetrahedron in one pixel: entry and exit from the cell's planes, then the integral between.
// Output: premultiplied colour and alpha, float, to be blended from back to front.

flat in int cell;

//VTK::Ray::Dec
//VTK::Clip::Dec
//VTK::TransferFunction::Dec
//VTK::Shading::Dec
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
  float base = 0.0;
  if (c.depth.y - c.depth.x < 1e-3 * abs(c.depth.x))
  {
    // Depths of a thin cell differ in their last digits: they are taken again from its own place.
    base = c.depth.x;
    c = crossingOf(texels, ray.point + base * ray.direction, ray.direction, ray.limits - base);
  }
  vec4 cornerScalars = texelFetch(cellScalars, cell);
  float front = scalarAt(c, cornerScalars, c.depth.x);
  float back = scalarAt(c, cornerScalars, c.depth.y);
  float len = max(c.depth.y - c.depth.x, 0.0) * ray.depthToLength;
  //VTK::Shading::Impl
  gl_FragData[0] = integrateSegment(front, back, len);
}
