//VTK::System::Dec
//VTK::Output::Dec

// Cell projection: one element in one pixel, from its entry to its exit.
// Output: premultiplied colour and alpha, float, to be blended from back to front.

//VTK::Ray::Dec
//VTK::Element::Dec
//VTK::Scalar::Dec
//VTK::Passage::Dec
//VTK::TransferFunction::Dec
//VTK::Integral::Dec
//VTK::Segment::Dec

const vec3 nudge = vec3(0.6180340, 0.4142136, 0.2360680); // along no face of a tidy mesh

// A ray inside a face counts as moved a little, all rays to the same side: it sees one of the face's
// two elements.
void leaveFaces(inout vec4 at, inout vec4 slope)
{
  vec4 aside = barycentricOf(nudge);
  vec4 steep = abs(slope);
  float crossing = 1.0 / max(max(steep.x, steep.y), max(steep.z, steep.w));
  for (int i = 0; i < 4; ++i)
  {
    if (abs(at[i]) <= elementTolerance[i] && steep[i] * crossing <= elementTolerance[i])
    {
      at[i] = aside[i] < 0.0 ? -1.0 : 1.0;
      slope[i] = 0.0;
    }
  }
}

void main()
{
  Ray ray = rayOfFragment();
  vec4 at, slope;
  float base = beside(ray, at, slope);
  vec4 atSide = at, slopeSide = slope;
  leaveFaces(atSide, slopeSide);
  vec2 passage = passageOf(atSide, slopeSide, vec4(0.0), ray.limits - base);
  if (!(passage.y > passage.x))
  {
    discard;
  }
  gl_FragData[0] = integrateSegment(scalarAt(at, slope, passage.x), scalarAt(at, slope, passage.y),
    (passage.y - passage.x) * ray.depthToLength);
}
