// The polygon within bounds (cpCellBounds): a box of four corners, or that box without the corners
// beyond its diagonal bounds, counterclockwise from its lower edge.

void toPolygon(vec4 l, vec4 h, vec2 axis, int count, out vec2 polygonVP[8])
{
  if (count == 4)
  {
    polygonVP[0] = l.xy;
    polygonVP[1] = vec2(h.x, l.y);
    polygonVP[2] = h.xy;
    polygonVP[3] = vec2(l.x, h.y);
  }
  else
  {
    polygonVP[0] = vec2(max(l.x, l.z - l.y), l.y);
    polygonVP[1] = vec2(min(h.x, h.w + l.y), l.y);
    polygonVP[2] = vec2(h.x, max(l.y, h.x - h.w));
    polygonVP[3] = vec2(h.x, min(h.y, h.z - h.x));
    polygonVP[4] = vec2(min(h.x, h.z - h.y), h.y);
    polygonVP[5] = vec2(max(l.x, l.w + h.y), h.y);
    polygonVP[6] = vec2(l.x, min(h.y, l.x - l.w));
    polygonVP[7] = vec2(l.x, max(l.y, l.z - l.x));
  }
  for (int i = 0; i < count; ++i)
  {
    vec2 p = polygonVP[i];
    polygonVP[i] = p.x * axis + p.y * vec2(-axis.y, axis.x);
  }
}
