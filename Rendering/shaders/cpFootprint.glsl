// A polygon on the screen that contains a tetrahedron's projection. It only selects pixels: coverage
// is decided by each fragment from the cell's planes.
// Input: corners in mesh coordinates; space of the results: pixels of the viewport (VP).

uniform mat4 meshToClip;
uniform vec2 viewportSize;
//VTK::NearClip::Dec
//VTK::Hull::Dec

// The box along `axis` of the points: a sliver at any angle stays thin.
void boxAlong(vec2 axis, vec2 pointVP[10], int count, out vec2 boxVP[4])
{
  vec2 side = vec2(-axis.y, axis.x);
  vec2 low = vec2(1e30);
  vec2 high = vec2(-1e30);
  for (int i = 0; i < count; ++i)
  {
    vec2 along = vec2(dot(pointVP[i], axis), dot(pointVP[i], side));
    low = min(low, along);
    high = max(high, along);
  }
  low -= margin;
  high += margin;
  boxVP[0] = low.x * axis + low.y * side;
  boxVP[1] = high.x * axis + low.y * side;
  boxVP[2] = high.x * axis + high.y * side;
  boxVP[3] = low.x * axis + high.y * side;
}

// Counterclockwise into `footprintVP`; returns its number of corners: 3, 4, or 0 behind the near plane.
int footprint(vec3 p[4], out vec2 footprintVP[4])
{
  vec4 clip[4];
  vec2 pointVP[10];
  bool cut = false;
  for (int i = 0; i < 4; ++i)
  {
    clip[i] = meshToClip * vec4(p[i], 1.0);
    cut = cut || clip[i].z < -clip[i].w;
    pointVP[i] = (clip[i].xy / clip[i].w * 0.5 + 0.5) * viewportSize;
  }
  if (!cut)
  {
    int corners = hullOf(pointVP, footprintVP);
    if (moveOutwards(corners, footprintVP))
    {
      return corners;
    }
  }
  int count = cut ? cutAtNearPlane(clip, pointVP) : 4;
  boxAlong(cut ? vec2(1.0, 0.0) : longestEdge(pointVP), pointVP, count, footprintVP);
  return count > 0 ? 4 : 0;
}
