//VTK::System::Dec
//VTK::Output::Dec

// Passes where there is opaque geometry, and changes nothing.

uniform sampler2D opaqueDepth;
uniform float nothing;

in vec2 texCoord;

void main()
{
  if (texture(opaqueDepth, texCoord).r >= 1.0)
  {
    discard;
  }
  gl_FragData[0] = vec4(nothing);
}
