//VTK::System::Dec

// Element assembly: one vertex per cell carries the ids of its corners and its own.

in ivec4 corners;
in int source;

flat out ivec4 cornersVSOutput;
flat out int sourceVSOutput;

void main()
{
  cornersVSOutput = corners;
  sourceVSOutput = source;
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
