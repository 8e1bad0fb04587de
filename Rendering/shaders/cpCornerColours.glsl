// Other components than the opacity's along a fragment's way through its cell (class
// DependentColors): linear in the share of the way that is passed.

uniform samplerBuffer cornerColours;
uniform int coloursPerCell; // not 0: one a cell, else one a point

vec4 colourEntry;
vec4 colourRise;

void beginColours(int cell, Crossing c)
{
  ivec4 ids = coloursPerCell != 0 ? ivec4(cell) : texelFetch(cornerIds, cell);
  vec4 entry = barycentricAt(c, c.depth.x);
  vec4 rise = barycentricAt(c, c.depth.y) - entry;
  colourEntry = vec4(0.0);
  colourRise = vec4(0.0);
  for (int i = 0; i < 4; ++i)
  {
    vec4 colour = texelFetch(cornerColours, ids[i]);
    colourEntry += entry[i] * colour;
    colourRise += rise[i] * colour;
  }
}
