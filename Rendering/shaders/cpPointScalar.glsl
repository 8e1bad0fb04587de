// The scalar at barycentric coordinates that add up to 1: linear between the corners.

float scalarOf(vec4 b)
{
  return dot(b, elementScalars);
}
