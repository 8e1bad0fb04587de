// What lies before a shell.

uniform sampler2D image;

const float nearlyOpaque = 0.99999;

bool isHidden()
{
  return texelFetch(image, ivec2(gl_FragCoord.xy), 0).a >= nearlyOpaque;
}
