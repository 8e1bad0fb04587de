//VTK::System::Dec

// Sets up one tetrahedron and emits a footprint that contains its projection.
// Input:  corner ids in ascending order, so that two cells compute the plane of their shared face
//         from the same numbers in the same order.
// Output: mesh coordinates (data coordinates about the mesh's centre, scaled to about 1).

layout(points) in;
layout(triangle_strip, max_vertices = 4) out;

flat in int cellVSOutput[1];

uniform isamplerBuffer cornerIds;
uniform samplerBuffer points;
uniform samplerBuffer scalars;
uniform int cellScalars;

flat out vec3 anchorFirst;   // corner 0: lies on the faces opposite corners 1, 2 and 3
flat out vec3 anchorSecond;  // corner 1: lies on the face opposite corner 0
flat out vec3 faceNormal[4]; // of the face opposite each corner: the same in the neighbour
flat out vec4 inverseHeight; // barycentric coordinate = (normal . offset from the anchor) * this;
                             // below zero where the normal points away from the cell
flat out vec4 cornerScalars;

//VTK::Footprint::Dec

void setPlane(int face, vec3 normal, vec3 towardsCorner)
{
  float height = dot(normal, towardsCorner);
  faceNormal[face] = normal;
  inverseHeight[face] = height != 0.0 ? 1.0 / height : 0.0;
}

void main()
{
  ivec4 ids = texelFetch(cornerIds, cellVSOutput[0]);
  vec3 p[4];
  for (int i = 0; i < 4; ++i)
  {
    p[i] = texelFetch(points, ids[i]).xyz;
  }
  vec2 boxVP[4];
  footprint(p, boxVP);
  for (int vertex = 0; vertex < 4; ++vertex)
  {
    // Emitting a vertex leaves every output undefined: all are set again.
    for (int i = 0; i < 4; ++i)
    {
      cornerScalars[i] = texelFetch(scalars, cellScalars != 0 ? cellVSOutput[0] : ids[i]).r;
    }
    setPlane(0, cross(p[2] - p[1], p[3] - p[1]), p[0] - p[1]);
    setPlane(1, cross(p[2] - p[0], p[3] - p[0]), p[1] - p[0]);
    setPlane(2, cross(p[1] - p[0], p[3] - p[0]), p[2] - p[0]);
    setPlane(3, cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]);
    anchorFirst = p[0];
    anchorSecond = p[1];
    gl_Position = vec4(2.0 * boxVP[vertex] / viewportSize - 1.0, 0.0, 1.0);
    EmitVertex();
  }
  EndPrimitive();
}
