//VTK::System::Dec

// Emits a footprint that contains one convex cell's projection.
// Input: the index of a cell. Output: the same index, for fragments to fetch the cell's planes by.

layout(points) in;
layout(triangle_strip, max_vertices = 8) out;

flat in int cellVSOutput[1];

flat out int cell;

//VTK::Footprint::Dec

void main()
{
  vec2 cornersVP[8];
  int count = footprint(cellVSOutput[0], cornersVP);
  for (int i = 0; i < count; ++i)
  {
    // The order of a strip: 0, 1, last, 2, last but one, ...
    int corner = i % 2 == 1 ? (i + 1) / 2 : (count - i / 2) % count;
    cell = cellVSOutput[0];
    gl_Position = vec4(2.0 * cornersVP[corner] / viewportSize - 1.0, 0.0, 1.0);
    EmitVertex();
  }
  EndPrimitive();
}
