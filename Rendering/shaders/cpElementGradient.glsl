// The gradient at a point of an element, from those of its corners, in view coordinates.

uniform samplerBuffer pointGradients; // mesh coordinates (class VertexGradients)
uniform mat3 gradientToView;

vec3 gradientOfElement(vec4 barycentric)
{
  vec3 gradient = vec3(0.0);
  for (int i = 0; i < 4; ++i)
  {
    gradient += barycentric[i] * texelFetch(pointGradients, elementIds[i]).xyz;
  }
  return gradientToView * gradient;
}
