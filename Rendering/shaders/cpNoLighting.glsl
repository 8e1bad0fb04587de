// Without lights: colours stay as they are.

vec3 shade(vec3 colour, float share)
{
  return colour;
}

float nextLight(float share)
{
  return 1.0;
}
