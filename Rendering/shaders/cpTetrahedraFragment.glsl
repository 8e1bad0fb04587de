//VTK::System::Dec
//VTK::Output::Dec

// One tetrahedron in one pixel: entry and exit from the cell's planes, then the exact integral.
// Output: premultiplied colour and alpha, float, to be blended from back to front.

flat in vec3 anchorFirst;
flat in vec3 anchorSecond;
flat in vec3 faceNormal[4];
flat in vec4 inverseHeight;
flat in vec4 cornerScalars;

//VTK::Ray::Dec
//VTK::Clip::Dec
//VTK::TransferFunction::Dec
//VTK::Integral::Dec
//VTK::Segment::Dec

void main()
{
  Ray ray = rayOfFragment();
  Crossing c = crossingOf(ray.point, ray.direction, ray.limits);
  // A flat cell has no height and no volume.
  if (!(c.depth.y > c.depth.x) || inverseHeight[0] == 0.0)
  {
    discard;
  }
  if (c.depth.y - c.depth.x < 1e-3 * abs(c.depth.x))
  {
    c = crossingOfThin(c, ray.point, ray.direction, ray.limits);
  }
  float front = scalarAt(c, c.depth.x);
  float back = scalarAt(c, c.depth.y);
  float len = max(c.depth.y - c.depth.x, 0.0) * ray.depthToLength;
  gl_FragData[0] = integrateSegment(front, back, len);
}
