// Where a ray is inside a tetrahedron: entry = largest depth of a front plane, exit = smallest depth
// of a back plane. Input: the flat outputs of cpTetrahedraGeometry.glsl.

const vec3 nudge = vec3(0.6180340, 0.4142136, 0.2360680); // along no face of a tidy mesh

struct Crossing
{
  vec4 value; // of each face's plane at the ray's point, positive inside
  vec4 slope; // its change per depth
  vec2 depth; // entry and exit
};

Crossing crossingOf(vec3 point, vec3 direction, vec2 limits)
{
  Crossing c;
  c.depth = limits;
  // Signs change no digit: what one cell finds on a shared face, its neighbour finds negated.
  vec4 inward = sign(inverseHeight);
  for (int i = 0; i < 4; ++i)
  {
    vec3 offset = point - (i == 0 ? anchorSecond : anchorFirst);
    c.value[i] = inward[i] * dot(faceNormal[i], offset);
    c.slope[i] = inward[i] * dot(faceNormal[i], direction);
    float depth = -c.value[i] / c.slope[i];
    c.depth.x = c.slope[i] > 0.0 ? max(c.depth.x, depth) : c.depth.x;
    c.depth.y = c.slope[i] < 0.0 ? min(c.depth.y, depth) : c.depth.y;
    // A ray inside a face counts as moved a little, all rays to the same side: it sees one of the
    // face's two cells, and the cells it sees follow each other through faces, in their order.
    float side = c.value[i] != 0.0 ? c.value[i] : inward[i] * dot(faceNormal[i], nudge);
    c.depth.y = c.slope[i] == 0.0 && side < 0.0 ? c.depth.x : c.depth.y;
  }
  return c;
}

// Depths of a thin cell differ in their last digits only: they are taken again from its own place.
Crossing crossingOfThin(Crossing c, vec3 point, vec3 direction, vec2 limits)
{
  float depth = c.depth.x;
  return crossingOf(point + depth * direction, direction, limits - depth);
}

float scalarAt(Crossing c, float depth)
{
  vec4 barycentric = max(c.value + depth * c.slope, 0.0) * abs(inverseHeight);
  return clamp(dot(barycentric, cornerScalars) / dot(barycentric, vec4(1.0)), 0.0, 1.0);
}
