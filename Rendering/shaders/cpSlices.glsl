// What the fragment stage left on the slices of a shell at this pixel.

uniform sampler2D slices0;
uniform sampler2D slices1;
uniform sampler2D slices2;
uniform sampler2D slices3;

in vec2 texCoord;

float sliceAt(int i)
{
  vec4 four = i < 4 ? texture(slices0, texCoord) : i < 8 ? texture(slices1, texCoord)
    : i < 12 ? texture(slices2, texCoord) : texture(slices3, texCoord);
  return four[i % 4];
}
