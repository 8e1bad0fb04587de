// The scalar at barycentric coordinates that add up to 1: that of an image bound to the mesh.

flat in ivec4 elementIds;

uniform samplerBuffer textureCoordinates; // 0 and 1 are the image's first and last points
uniform sampler3D volumeTexture;

float scalarOf(vec4 b)
{
  vec3 place = vec3(0.0);
  for (int i = 0; i < 4; ++i)
  {
    place += b[i] * texelFetch(textureCoordinates, elementIds[i]).xyz;
  }
  vec3 size = vec3(textureSize(volumeTexture, 0));
  return texture(volumeTexture, (place * (size - 1.0) + 0.5) / size).r;
}
