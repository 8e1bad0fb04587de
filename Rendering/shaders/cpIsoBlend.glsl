//VTK::System::Dec
//VTK::Output::Dec

// A layer of iso-surfaces, to be blended below those before it.

uniform sampler2D layer;

in vec2 texCoord;

void main()
{
  gl_FragData[0] = texture(layer, texCoord);
}
