// Warped faces whose diagonal is a valley of the cell: a ray is inside beyond either of two planes.
// Where it leaves such a cell and enters it again, the cell reaches from the first to the last point.

// Front: inside from a depth on; back: inside up to a depth.
void cutAtValley(int plane, Ray ray, float parallel, inout Passage p)
{
  Passage each[2];
  for (int i = 0; i < 2; ++i)
  {
    each[i] = p;
    each[i].depths = vec2(-farAway, farAway);
    cutAtPlane(plane + i, ray, parallel, each[i]);
  }
  vec2 begins = vec2(each[0].depths.x, each[1].depths.x);
  vec2 ends = vec2(each[0].depths.y, each[1].depths.y);
  bvec2 front = greaterThan(begins, vec2(-farAway));
  float enter = all(front) ? min(begins.x, begins.y) : max(begins.x, begins.y);
  float leave = any(front) ? min(ends.x, ends.y) : max(ends.x, ends.y);
  bool mixed = front.x != front.y;
  bool enters = enter > p.depths.x && (!mixed || p.depths.x > leave);
  p.depths.x = enters ? enter : p.depths.x;
  p.planes.x = enters ? plane : p.planes.x;
  bool leaves = leave < p.depths.y && (!mixed || p.depths.y < enter);
  p.depths.y = leaves ? leave : p.depths.y;
  p.planes.y = leaves ? plane : p.planes.y;
}

Passage passageOf(int cell, Ray ray)
{
  ivec4 header = texelFetch(cellHeaders, cell);
  int pairs = header.y / 65536, planes = header.y % 65536;
  Passage p;
  p.center = texelFetch(cellPlanes, header.x).xyz;
  p.depth = dot(p.center - ray.point, ray.direction) / dot(ray.direction, ray.direction);
  p.place = (ray.point - p.center) + p.depth * ray.direction;
  p.depths = header.y > 0 ? vec2(-farAway, farAway) : vec2(0.0);
  p.planes = ivec2(header.x);
  float parallel = 1e-6 * length(ray.direction);
  for (int i = 1; i <= planes; ++i)
  {
    cutAtPlane(header.x + i, ray, parallel, p);
  }
  // Far from the centre of a flat cell depths lose the digits of its thickness: again from its front.
  if (pairs == 0 && p.depths.x < p.depths.y && 64.0 * (p.depths.y - p.depths.x) < abs(p.depths.x))
  {
    p.depth += p.depths.x;
    p.place += p.depths.x * ray.direction;
    p.depths = vec2(-farAway, farAway);
    cutAtPlane(p.planes.x, ray, parallel, p);
    cutAtPlane(p.planes.y, ray, parallel, p);
  }
  // Twice: an end that a later face moves may come to lie in the gap of an earlier one.
  for (int i = 0; i < 2 * pairs; ++i)
  {
    cutAtValley(header.x + 1 + planes + 2 * (i % pairs), ray, parallel, p);
  }
  return p;
}
