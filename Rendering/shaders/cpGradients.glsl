// The gradient along a fragment's way through its cell, and the way itself: linear in the share of
// the way that is passed, in view coordinates.

uniform samplerBuffer pointGradients; // mesh coordinates (class VertexGradients)
uniform isamplerBuffer cornerIds;
uniform mat3 gradientToView;

vec3 gradientEntry;
vec3 gradientRise;
vec3 wayEntry;
vec3 wayRise;
vec3 toEye; // of unit length

vec3 gradientAt(float share)
{
  return gradientEntry + share * gradientRise;
}

// Depths of the crossing count from `base`.
void beginShading(int cell, Crossing c, float base)
{
  ivec4 ids = texelFetch(cornerIds, cell);
  vec4 entry = barycentricAt(c, c.depth.x);
  vec4 rise = barycentricAt(c, c.depth.y) - entry;
  gradientEntry = vec3(0.0);
  gradientRise = vec3(0.0);
  for (int i = 0; i < 4; ++i)
  {
    vec3 gradient = texelFetch(pointGradients, ids[i]).xyz;
    gradientEntry += entry[i] * gradient;
    gradientRise += rise[i] * gradient;
  }
  gradientEntry = gradientToView * gradientEntry;
  gradientRise = gradientToView * gradientRise;
  vec2 step = gl_FragCoord.xy - rayPixel;
  vec4 view = rayView[0] + step.x * rayView[1] + step.y * rayView[2];
  vec3 direction = vec3(view.zw, -1.0);
  wayEntry = vec3(view.xy, -rayDepths.x) + (base + c.depth.x) * direction;
  wayRise = (c.depth.y - c.depth.x) * direction;
  toEye = -normalize(direction);
}
