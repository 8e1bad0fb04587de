//VTK::System::Dec

// A vertex of a triangle that stands for a cell. All is linear on the screen.

in vec4 place; // xy normalised device coordinates; z depth where the cell begins, w its thickness
in vec4 value; // rgb colour, a opacity or extinction per world length

out vec2 depthsVSOutput;
out vec4 valueVSOutput;

void main()
{
  depthsVSOutput = place.zw;
  valueVSOutput = value;
  gl_Position = vec4(place.xy, 0.0, 1.0);
}
