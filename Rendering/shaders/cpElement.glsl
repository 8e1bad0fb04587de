// Barycentric coordinates along a fragment's ray, from what primitive construction left.

flat in vec3 elementRows[3];
flat in vec3 elementCorner;
flat in vec4 elementTolerance;
flat in vec4 elementScalars;

// Of a direction; of an offset from the first corner add 1 to the first.
vec4 barycentricOf(vec3 direction)
{
  vec3 inner = vec3(dot(elementRows[0], direction), dot(elementRows[1], direction),
    dot(elementRows[2], direction));
  return vec4(-(inner.x + inner.y + inner.z), inner);
}

// At the ray's place at `depth`.
vec4 barycentricAt(Ray ray, float depth)
{
  return barycentricOf((ray.point - elementCorner) + depth * ray.direction) + vec4(1.0, vec3(0.0));
}

// Coordinates and their change per depth at the ray's place next to the element, where floats are
// finest; returns its depth.
float beside(Ray ray, out vec4 at, out vec4 slope)
{
  vec3 offset = ray.point - elementCorner;
  float depth = -dot(offset, ray.direction) / dot(ray.direction, ray.direction);
  at = barycentricOf(offset + depth * ray.direction) + vec4(1.0, vec3(0.0));
  slope = barycentricOf(ray.direction);
  return depth;
}
