// The light on a point.

vec3 shade(vec3 colour, float share)
{
  Light light = lightAt(share);
  return colour * (light.ambient + light.diffuse) + light.highlight;
}
