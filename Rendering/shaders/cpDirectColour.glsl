// Three components are the colour itself.

vec3 baseColour(vec3 colour, float share)
{
  return colourEntry.rgb + share * colourRise.rgb;
}

float nextColour(float share)
{
  return 1.0;
}
