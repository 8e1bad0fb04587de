//VTK::System::Dec

// Primitive construction: what is computed once per element, and a footprint that contains its
// projection. Barycentric coordinate i > 0 of a point p is dot(elementRows[i - 1].xyz, p - first
// corner): the inverse of the matrix of the corners, about a corner and not about the eye, for an
// eye far from a small cell would take its digits.
// Input: ids of corners; mesh coordinates. Output: rows, corner and scalars, flat.

layout(points) in;
layout(triangle_strip, max_vertices = 4) out;

flat in ivec4 cornersVSOutput[1];
flat in int sourceVSOutput[1];

uniform samplerBuffer points;
uniform samplerBuffer scalars;
uniform int scalarKind; // 0: one per point, 1: one per cell, 2: none

flat out vec3 elementRows[3];
flat out vec3 elementCorner;
flat out vec4 elementTolerance; // by how much rounding moves a barycentric coordinate
flat out vec4 elementScalars;
//VTK::Attributes::Dec

//VTK::Footprint::Dec
//VTK::Inverse::Dec

void main()
{
  ivec4 ids = cornersVSOutput[0];
  vec3 p[4];
  vec4 cornerScalars;
  for (int i = 0; i < 4; ++i)
  {
    p[i] = texelFetch(points, ids[i]).xyz;
    int scalar = scalarKind == 0 ? ids[i] : scalarKind == 1 ? sourceVSOutput[0] : 0;
    cornerScalars[i] = texelFetch(scalars, scalar).r;
  }
  vec3 rows[3];
  vec4 tolerance;
  vec2 cornersVP[4];
  int count = invert(p, rows, tolerance) ? footprint(p, cornersVP) : 0;
  for (int i = 0; i < count; ++i)
  {
    // The order of a strip: 0 1 2 of three, 0 1 3 2 of four.
    int corner = count == 4 && i > 1 ? 5 - i : i;
    elementRows = rows;
    elementCorner = p[0];
    elementTolerance = tolerance;
    elementScalars = cornerScalars;
    //VTK::Attributes::Impl
    gl_Position = vec4(2.0 * cornersVP[corner] / viewportSize - 1.0, 0.0, 1.0);
    EmitVertex();
  }
  EndPrimitive();
}
