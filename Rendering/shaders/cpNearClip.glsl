// The part of a tetrahedron before the near plane, as points on the screen.
// Input: corners in clip coordinates. Output: up to 4 corners and 6 crossings, kept within the
// surroundings of the viewport, where a float still tells pixels apart.

void append(vec4 clip, inout vec2 pointVP[10], inout int count)
{
  vec2 ndc = clamp(clip.xy / max(clip.w, 1e-30), -4.0, 4.0);
  pointVP[count] = (ndc * 0.5 + 0.5) * viewportSize;
  ++count;
}

int cutAtNearPlane(vec4 clip[4], inout vec2 pointVP[10])
{
  int count = 0;
  for (int i = 0; i < 4; ++i)
  {
    float before = clip[i].z + clip[i].w;
    if (before >= 0.0)
    {
      append(clip[i], pointVP, count);
    }
    for (int j = i + 1; j < 4; ++j)
    {
      float other = clip[j].z + clip[j].w;
      if (before >= 0.0 != other >= 0.0)
      {
        append(mix(clip[i], clip[j], before / (before - other)), pointVP, count);
      }
    }
  }
  return count;
}

vec2 longestEdge(vec2 pointVP[10])
{
  vec2 longest = vec2(1.0, 0.0);
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i + 1; j < 4; ++j)
    {
      vec2 edge = pointVP[j] - pointVP[i];
      longest = dot(edge, edge) > dot(longest, longest) ? edge : longest;
    }
  }
  return normalize(longest);
}
