//VTK::System::Dec
//VTK::Output::Dec

// Counts the pixels that are not opaque yet, by a query. Changes no slice: it draws the least value.

uniform sampler2D image; // what lies before the shell

in vec2 texCoord;

void main()
{
  if (texture(image, texCoord).a >= 0.99999)
  {
    discard;
  }
  gl_FragData[0] = vec4(-16777216.0);
  gl_FragData[1] = vec4(-16777216.0);
  gl_FragData[2] = vec4(-16777216.0);
  gl_FragData[3] = vec4(-16777216.0);
}
