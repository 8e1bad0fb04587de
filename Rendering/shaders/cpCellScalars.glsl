// The scalars at both ends of a ray's way through a cell, linear in between.

uniform isamplerBuffer planePieces; // of a plane: the first piece of its face

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
  int front = texelFetch(planePieces, p.planes.x).r;
  int back = texelFetch(planePieces, p.planes.y).r;
  scalars.x = scalarOnFace(front, p.center, p.place + whole.x * ray.direction);
  scalars.y = scalarOnFace(back, p.center, p.place + whole.y * ray.direction);
  vec2 share = clamp((p.depths - whole.x) / (whole.y - whole.x), 0.0, 1.0);
  scalars = mix(scalars.xx, scalars.yy, share);
  return true;
}
