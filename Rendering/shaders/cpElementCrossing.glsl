// Where a fragment's ray enters and leaves its element, from the faces alone.

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

// Steps from the depth `base`: b = at + step * slope.
vec2 crossElement(Ray ray, out float base, out vec4 at, out vec4 slope)
{
  base = beside(ray, at, slope);
  vec4 atSide = at, slopeSide = slope;
  leaveFaces(atSide, slopeSide);
  return passageOf(atSide, slopeSide, vec4(0.0), ray.limits - base);
}
