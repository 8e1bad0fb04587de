// One component is the scalar of the colour function, piecewise linear as the transfer function is.

uniform samplerBuffer colourPositions;
uniform samplerBuffer colourValues;
uniform int numberOfColourNodes;

vec3 baseColour(vec3 colour, float share)
{
  float position = colourEntry.x + share * colourRise.x;
  int low = 0;
  int high = numberOfColourNodes - 1;
  while (high - low > 1)
  {
    int middle = (low + high) / 2;
    bool above = position >= texelFetch(colourPositions, middle).r;
    low = above ? middle : low;
    high = above ? high : middle;
  }
  float below = texelFetch(colourPositions, low).r;
  float width = texelFetch(colourPositions, low + 1).r - below;
  float weight = width > 0.0 ? clamp((position - below) / width, 0.0, 1.0) : 0.0;
  return mix(texelFetch(colourValues, low).rgb, texelFetch(colourValues, low + 1).rgb, weight);
}

// The share at which the scalar passes the next node.
float nextColour(float share)
{
  float next = 1.0;
  for (int i = 1; i + 1 < numberOfColourNodes; ++i)
  {
    float node = (texelFetch(colourPositions, i).r - colourEntry.x) / colourRise.x;
    next = node > share + 1e-4 ? min(next, node) : next;
  }
  return next;
}
