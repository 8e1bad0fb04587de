// The inverse of a tetrahedron's edge matrix, and how far rounding lets it be off.

// False for a flat element: it has no inside.
bool invert(vec3 p[4], out vec3 rows[3], out vec4 tolerance)
{
  vec3 a = p[1] - p[0];
  vec3 b = p[2] - p[0];
  vec3 c = p[3] - p[0];
  float determinant = dot(a, cross(b, c));
  rows[0] = cross(b, c) / determinant;
  rows[1] = cross(c, a) / determinant;
  rows[2] = cross(a, b) / determinant;
  vec4 perLength = vec4(length(rows[0] + rows[1] + rows[2]), length(rows[0]), length(rows[1]),
    length(rows[2]));
  // Mesh coordinates are about 1 and have 24 bits; the edges of a sliver cancel in its volume. A quarter of
  // this still leaves no gap in the tests' meshes, none does.
  float sliver = length(a) * length(b) * length(c) / abs(determinant);
  tolerance = 5e-7 * perLength + 2e-7 * sliver;
  return determinant != 0.0;
}
