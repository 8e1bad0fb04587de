// Where a ray through the origin meets a triangle.
// Neighbours leave no gap: the triangle counts as wider by the rounding of mesh coordinates, and a
// scalar beside it is that of its rim.

const float reach = 4e-7;

// `hit`: depth and scalar. A triangle seen edge-on is not met: its neighbours are.
bool meetsTriangle(vec3 a, vec3 b, vec3 c, vec3 direction, vec3 scalars, out vec2 hit)
{
  // Areas as seen along the ray, each of a corner's far edge and the ray.
  vec3 areas = vec3(dot(direction, cross(b, c)), dot(direction, cross(c, a)),
    dot(direction, cross(a, b)));
  float sum = areas.x + areas.y + areas.z;
  vec3 lengths = vec3(dot(c - b, c - b), dot(a - c, a - c), dot(b - a, b - a));
  float longest = sqrt(max(lengths.x, max(lengths.y, lengths.z)));
  float tolerance = reach * longest * length(direction);
  vec3 weights = areas * sign(sum);
  hit = vec2(0.0);
  if (min(weights.x, min(weights.y, weights.z)) < -tolerance || abs(sum) <= 4.0 * tolerance)
  {
    return false;
  }
  weights = max(weights, 0.0);
  weights /= weights.x + weights.y + weights.z;
  vec3 point = weights.x * a + weights.y * b + weights.z * c;
  hit = vec2(dot(point, direction) / dot(direction, direction), dot(weights, scalars));
  return true;
}
