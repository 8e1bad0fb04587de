// The gradient at a vertex of an iso-surface, for its fragments: view coordinates.

uniform samplerBuffer triangleGradients; // mesh coordinates
uniform mat3 gradientToView;

out vec3 gradientVSOutput;

void takeGradient(int vertex)
{
  gradientVSOutput = gradientToView * texelFetch(triangleGradients, vertex).xyz;
}
