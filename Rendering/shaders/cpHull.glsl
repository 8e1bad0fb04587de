// The convex hull of a tetrahedron's four projected corners, three or four of them, moved outwards.
// The margin covers the rasteriser's snapping of vertices; pixel centres need no more.

const float margin = 0.25;

float turn(vec2 a, vec2 b, vec2 c)
{
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Counterclockwise into `hullVP`; returns how many.
int hullOf(vec2 pointVP[10], out vec2 hullVP[4])
{
  bool turned = turn(pointVP[0], pointVP[1], pointVP[2]) < 0.0;
  vec2 corner[3];
  corner[0] = pointVP[0];
  corner[1] = turned ? pointVP[2] : pointVP[1];
  corner[2] = turned ? pointVP[1] : pointVP[2];
  vec2 last = pointVP[3];
  bool beyond[3];
  int count = 0;
  for (int i = 0; i < 3; ++i)
  {
    beyond[i] = turn(corner[i], corner[(i + 1) % 3], last) < 0.0;
  }
  for (int i = 0; i < 3; ++i)
  {
    // A corner that the last point sees over both of its edges lies behind that point.
    bool hidden = beyond[i] && beyond[(i + 2) % 3];
    hullVP[count++] = hidden ? last : corner[i];
    if (beyond[i] && !beyond[(i + 1) % 3] && !beyond[(i + 2) % 3])
    {
      hullVP[count++] = last;
    }
  }
  return count;
}

// False where an edge is too short to have a direction, or a corner so sharp that its tip would
// move far away.
bool moveOutwards(int count, inout vec2 hullVP[4])
{
  vec2 outward[4];
  bool good = true;
  for (int i = 0; i < count; ++i)
  {
    vec2 edge = hullVP[(i + 1) % count] - hullVP[i];
    good = good && dot(edge, edge) > 1e-4;
    outward[i] = normalize(vec2(edge.y, -edge.x));
  }
  for (int i = 0; i < count; ++i)
  {
    vec2 before = outward[(i + count - 1) % count];
    float sharpness = 1.0 + dot(before, outward[i]);
    good = good && sharpness > 1e-3;
    hullVP[i] += margin * (before + outward[i]) / sharpness;
  }
  return good;
}
