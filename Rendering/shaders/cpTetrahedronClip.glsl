// Where a ray is inside a tetrahedron: from the largest depth of a front plane to the smallest of a
// back plane (class TetrahedraPlanes).

uniform samplerBuffer cellPlanes;  // 6 texels a cell
uniform samplerBuffer cellScalars; // of the four corners

const float nothing = 1e-6; // a slope or height by rounding: fused sums leave it where products cancel
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
  float parallel = nothing * length(direction);
  for (int i = 0; i < 4; ++i)
  {
    vec4 plane = texels[i];
    // Signs change no digit: what one cell finds on a shared face, its neighbour finds negated.
    float inward = sign(plane.w);
    c.inverseHeight[i] = abs(plane.w);
    c.value[i] = inward * dot(plane.xyz, point - texels[i == 0 ? 5 : 4].xyz);
    c.slope[i] = inward * dot(plane.xyz, direction);
    float depth = -c.value[i] / c.slope[i];
    c.depth.x = c.slope[i] > parallel ? max(c.depth.x, depth) : c.depth.x;
    c.depth.y = c.slope[i] < -parallel ? min(c.depth.y, depth) : c.depth.y;
    // A ray inside a face counts as moved a little, all to one side: it sees one of two cells.
    float side = abs(c.value[i]) > nothing ? c.value[i] : inward * dot(plane.xyz, nudge);
    c.depth.y = abs(c.slope[i]) <= parallel && side < 0.0 ? c.depth.x : c.depth.y;
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
