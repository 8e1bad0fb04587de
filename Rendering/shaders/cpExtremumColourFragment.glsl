//VTK::System::Dec
//VTK::Output::Dec

// Colour and opacity of the extremum that was found in a pixel, premultiplied.

uniform sampler2D extrema;

//VTK::TransferFunction::Dec

in vec2 texCoord;

void main()
{
  float scalar = texture(extrema, texCoord).r;
  // What the image was cleared to.
  if (abs(scalar) > 3e38)
  {
    discard;
  }
  vec4 value = valueInInterval(firstInterval(scalar, false), scalar);
  float alpha = min(value.a, 1.0);
  gl_FragData[0] = vec4(value.rgb * alpha, alpha);
}
