//VTK::System::Dec

// Sets up one tetrahedron and emits a footprint that contains its projection.
// Input:  the index of a cell. Output: mesh coordinates (data coordinates about the mesh's centre,
//         scaled to about 1).

layout(points) in;
layout(triangle_strip, max_vertices = 4) out;

flat in int cellVSOutput[1];

uniform isamplerBuffer cornerIds;
uniform samplerBuffer points;
uniform samplerBuffer scalars;
uniform int cellScalars;

flat out vec3 anchorFirst;   // corner 0: lies on the faces opposite corners 1, 2 and 3
flat out vec3 anchorSecond;  // corner 1: lies on the face opposite corner 0
flat out vec3 faceNormal[4];
flat out vec4 inverseHeight; // barycentric coordinate = (normal . offset from the anchor) * this
flat out vec4 cornerScalars;

//VTK::Footprint::Dec
//VTK::Planes::Dec

void main()
{
  ivec4 ids = texelFetch(cornerIds, cellVSOutput[0]);
  vec3 p[4];
  vec4 s;
  for (int i = 0; i < 4; ++i)
  {
    p[i] = texelFetch(points, ids[i]).xyz;
    s[i] = texelFetch(scalars, cellScalars != 0 ? cellVSOutput[0] : ids[i]).r;
  }
  vec2 boxVP[4];
  footprint(p, boxVP);
  Planes planes = planesOf(p);
  for (int vertex = 0; vertex < 4; ++vertex)
  {
    // Emitting a vertex leaves every output undefined: all are set again.
    faceNormal = planes.normal;
    inverseHeight = planes.inverseHeight;
    anchorFirst = p[0];
    anchorSecond = p[1];
    cornerScalars = s;
    gl_Position = vec4(2.0 * boxVP[vertex] / viewportSize - 1.0, 0.0, 1.0);
    EmitVertex();
  }
  EndPrimitive();
}
