//VTK::System::Dec

// Passes a cell's index on: its corners are fetched by the geometry shader.
// Input:  gl_VertexID, the index in the buffer of drawn cells.

flat out int cellVSOutput;

void main()
{
  cellVSOutput = gl_VertexID;
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
