// Where a ray is inside a tetrahedron: entry = largest depth of a front plane, exit = smallest depth
// of a back plane. Planes come from class TetrahedraPlanes.

uniform samplerBuffer cellPlanes;  // 6 texels a cell
uniform samplerBuffer cellScalars; // of the four corners

const vec3 nudge = vec3(0.6180340, 0.4142136, 0.2360680); // along no face of a tidy mesh

struct Crossing
{
  vec4 value; // of each face's plane at the ray's point, positive inside
  vec4 slope; // its change per depth
  vec4 inverseHeight; // of each corner over its face: turns the value into a barycentric coordinate
  vec2 depth; // entry and exit
};

void fetchCell(int cell, out vec4 texels[6])
{
  for (int i = 0; i < 6; ++i)
  {
    texels[i] = texelFetch(cellPlanes, 6 * cell + i);
  }
}

Crossing crossingOf(vec4 texels[6], vec3 point, vec3 direction, vec2 limits)
{
  Crossing c;
  c.depth = limits;
  for (int i = 0; i < 4; ++i)
  {
    vec4 plane = texels[i];
    vec3 anchor = texels[i == 0 ? 5 : 4].xyz;
    // Signs change no digit: what one cell finds on a shared face, its neighbour finds negated.
    float inward = sign(plane.w);
    c.inverseHeight[i] = abs(plane.w);
    c.value[i] = inward * dot(plane.xyz, point - anchor);
    c.slope[i] = inward * dot(plane.xyz, direction);
    float depth = -c.value[i] / c.slope[i];
    c.depth.x = c.slope[i] > 0.0 ? max(c.depth.x, depth) : c.depth.x;
    c.depth.y = c.slope[i] < 0.0 ? min(c.depth.y, depth) : c.depth.y;
    // A ray inside a face counts as moved a little, all rays to the same side: it sees one of the
    // face's two cells, and the cells it sees follow each other through faces, in their order.
    float side = c.value[i] != 0.0 ? c.value[i] : inward * dot(plane.xyz, nudge);
    c.depth.y = c.slope[i] == 0.0 && side < 0.0 ? c.depth.x : c.depth.y;
  }
  return c;
}

vec4 barycentricAt(Crossing c, float depth)
{
  vec4 barycentric = max(c.value + depth * c.slope, 0.0) * c.inverseHeight;
  return barycentric / dot(barycentric, vec4(1.0));
}

float scalarAt(Crossing c, vec4 cornerScalars, float depth)
{
  vec4 barycentric = max(c.value + depth * c.slope, 0.0) * c.inverseHeight;
  return dot(barycentric, cornerScalars) / dot(barycentric, vec4(1.0));
}
