// The colour is that of the transfer function.

vec3 baseColour(vec3 colour, float share)
{
  return colour;
}

float nextColour(float share)
{
  return 1.0;
}
