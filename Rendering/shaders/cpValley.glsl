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
  bvec2 front = bvec2(each[0].depths.x > -farAway, each[1].depths.x > -farAway);
  float enter = front.x && front.y ? min(each[0].depths.x, each[1].depths.x)
                                   : max(each[0].depths.x, each[1].depths.x);
  float leave = !front.x && !front.y ? max(each[0].depths.y, each[1].depths.y)
                                     : min(each[0].depths.y, each[1].depths.y);
  bool mixed = front.x != front.y;
  if (mixed ? p.depths.x > leave && enter > p.depths.x : enter > p.depths.x)
  {
    p.depths.x = enter;
    p.planes.x = plane;
  }
  if (mixed ? p.depths.y < enter && leave < p.depths.y : leave < p.depths.y)
  {
    p.depths.y = leave;
    p.planes.y = plane;
  }
}

Passage passageOf(int cell, Ray ray)
{
  ivec4 header = texelFetch(cellHeaders, cell);
  int pairs = header.y / 65536;
  int planes = header.y - 65536 * pairs;
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
  // Twice: an end that a later face moves may come to lie in the gap of an earlier one.
  for (int i = 0; i < 2 * pairs; ++i)
  {
    cutAtValley(header.x + 1 + planes + 2 * (i % pairs), ray, parallel, p);
  }
  return p;
}
