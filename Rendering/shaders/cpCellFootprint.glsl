// A polygon on the screen that contains a convex cell's projection, an octagon. It only selects
// pixels: coverage is decided by each fragment from the cell's planes.
// Input: the index of a cell; space of the results: pixels of the viewport (VP).
//VTK::Bounds::Dec
//VTK::Octagon::Dec

const float margin = 0.25;   // covers the rasteriser's snapping of vertices
const float smallArea = 25.0; // in pixels: below it, more corners cost more than more pixels

// The direction to the corner farthest from the first: a sliver at any angle stays thin.
vec2 axisOf(ivec4 header, out bool upright)
{
  vec2 axis = vec2(1e-3, 0.0);
  upright = needsBox(clipOf(header.z));
  vec2 first = pixelOf(clipOf(header.z));
  for (int i = header.z + 1; i < header.z + header.w; ++i)
  {
    vec4 clip = clipOf(i);
    upright = upright || needsBox(clip);
    vec2 edge = pixelOf(clip) - first;
    axis = dot(edge, edge) > dot(axis, axis) ? edge : axis;
  }
  return upright ? vec2(1.0, 0.0) : normalize(axis);
}

// Counterclockwise into `polygonVP`; returns its number of corners: 8, 4, or 0 behind the near plane.
int footprint(int cell, out vec2 polygonVP[8])
{
  ivec4 header = texelFetch(cellHeaders, cell);
  Bounds b = Bounds(vec4(1e30), vec4(-1e30));
  bool upright;
  vec2 axis = axisOf(header, upright);
  int end = header.z + header.w;
  for (int i = header.z; i < end; ++i)
  {
    vec4 clip = clipOf(i);
    if (!isBehindNearPlane(clip))
    {
      extend(pixelOf(clip), axis, b);
    }
    if (upright)
    {
      extendToCuts(i + 1, end, clip, axis, b);
    }
  }
  vec4 l = b.low - margin * vec4(1.0, 1.0, 1.4143, 1.4143);
  vec4 h = b.high + margin * vec4(1.0, 1.0, 1.4143, 1.4143);
  vec2 size = h.xy - l.xy;
  int count = size.x <= 0.0 ? 0 : upright || size.x * size.y < smallArea ? 4 : 8;
  toPolygon(l, h, axis, count, polygonVP);
  return count;
}
