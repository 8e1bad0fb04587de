// What light makes of a colour, and the share at which it next changes its course along the way:
// the gradient has turned, or a light passes from one side of it to the other.

vec3 shade(vec3 colour, float share)
{
  Light light = lightAt(share);
  return colour * (light.ambient + light.diffuse) + light.highlight;
}

float nextLight(float share)
{
  float next = nextTurn(share);
  for (int i = 0; i < numberOfLights; ++i)
  {
    float arriving;
    vec3 way = toLight(i, wayEntry + 0.5 * wayRise, arriving);
    float side = -dot(gradientEntry, way) / dot(gradientRise, way);
    next = side > share + 1e-4 ? min(next, side) : next;
    // Of a higher power the highlight starts smoothly.
    if (material.z > 0.0 && material.w < 2.0)
    {
      next = min(next, nextGlance(way, share));
    }
  }
  return next;
}
