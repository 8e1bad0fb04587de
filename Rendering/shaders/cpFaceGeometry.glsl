//VTK::System::Dec

// Emits a footprint that contains the projection of one piece of a face.
// Input: the index of a piece. Output: the same index.

layout(points) in;
layout(triangle_strip, max_vertices = 4) out;

flat in int cellVSOutput[1];

uniform isamplerBuffer pieceCorners;
uniform samplerBuffer points;

flat out int piece;

//VTK::Footprint::Dec

void main()
{
  ivec4 ids = texelFetch(pieceCorners, cellVSOutput[0]);
  vec3 p[4];
  for (int i = 0; i < 4; ++i)
  {
    p[i] = texelFetch(points, ids[i]).xyz;
  }
  vec2 cornersVP[4];
  int count = footprint(p, cornersVP);
  for (int i = 0; i < count; ++i)
  {
    // The order of a strip: 0 1 2 of three, 0 1 3 2 of four.
    int corner = count == 4 && i > 1 ? 5 - i : i;
    piece = cellVSOutput[0];
    gl_Position = vec4(2.0 * cornersVP[corner] / viewportSize - 1.0, 0.0, 1.0);
    EmitVertex();
  }
  EndPrimitive();
}
