// The scalars at both ends of a ray's way through a cell, linear in between.

// Cuts the way at the ray's limits; false where nothing is left of it.
bool scalarsAlong(int cell, Ray ray, inout Passage p, out vec2 scalars)
{
  vec2 whole = p.depths;
  p.depths = vec2(max(whole.x, ray.limits.x - p.depth), min(whole.y, ray.limits.y - p.depth));
  if (!(p.depths.y > p.depths.x))
  {
    return false;
  }
  if (onePerCell != 0)
  {
    scalars = vec2(texelFetch(cellValues, cell).r);
    return true;
  }
  for (int end = 0; end < 2; ++end)
  {
    int piece = texelFetch(planePieces, p.planes[end]).r;
    scalars[end] = scalarOnFace(piece, p.center, p.place + whole[end] * ray.direction);
  }
  vec2 share = clamp((p.depths - whole.x) / (whole.y - whole.x), 0.0, 1.0);
  scalars = mix(scalars.xx, scalars.yy, share);
  return true;
}
