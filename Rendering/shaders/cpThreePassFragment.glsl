//VTK::System::Dec
//VTK::Output::Dec

// A face of a cell in one pixel. Pass 0: back faces add their depth to alpha, front faces subtract
// theirs, each as a share of the depth that the cell can have; pass 1: the emission times half that
// depth, to be multiplied by alpha; pass 2: alpha is taken back.

in float depthVSOutput;
in float scalarVSOutput;
flat in vec2 cellVSOutput;
flat in int passVSOutput;

uniform int isMirrored;

//VTK::Ray::Dec
//VTK::TransferFunction::Dec

void main()
{
  Ray ray = rayOfFragment();
  vec2 limits = ray.limits - cellVSOutput.x;
  if (passVSOutput == 1)
  {
    vec4 value = valueInInterval(firstInterval(scalarVSOutput, false), scalarVSOutput);
    gl_FragData[0] = vec4(value.a * value.rgb * cellVSOutput.y * ray.depthToLength, 0.0);
    return;
  }
  float depth = clamp(depthVSOutput, limits.x, max(limits.x, limits.y));
  float alpha = 0.5 + 0.5 * depth / cellVSOutput.y;
  bool isFront = gl_FrontFacing != (isMirrored != 0);
  gl_FragData[0] = vec4(0.0, 0.0, 0.0, isFront == (passVSOutput == 0) ? -alpha : alpha);
}
