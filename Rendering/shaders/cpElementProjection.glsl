//VTK::System::Dec
//VTK::Output::Dec

// Cell projection: one element in one pixel, from its entry to its exit.
// Output: premultiplied colour and alpha, float, to be blended from back to front.

//VTK::Ray::Dec
//VTK::Element::Dec
//VTK::Scalar::Dec
//VTK::Passage::Dec
//VTK::Crossing::Dec
//VTK::Layer::Dec
//VTK::TransferFunction::Dec
//VTK::Integral::Dec
//VTK::Segment::Dec

void main()
{
  Ray ray = rayOfFragment();
  float base;
  vec4 at, slope;
  vec2 passage = crossElement(ray, base, at, slope);
  if (!(passage.y > passage.x))
  {
    discard;
  }
  //VTK::Layer::Impl
  gl_FragData[0] = integrateSegment(scalarAt(at, slope, passage.x), scalarAt(at, slope, passage.y),
    (passage.y - passage.x) * ray.depthToLength);
}
