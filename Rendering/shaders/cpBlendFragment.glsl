//VTK::System::Dec
//VTK::Output::Dec

// Copies the volume's float image to its viewport; the blend function lays it over the scene.

uniform sampler2D volumeImage;

in vec2 texCoord;

void main()
{
  gl_FragData[0] = texture(volumeImage, texCoord);
}
