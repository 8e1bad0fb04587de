// A point on an iso-surface for cpLighting.glsl: a way of no length, view coordinates.

vec3 gradientEntry;
const vec3 gradientRise = vec3(0.0);
vec3 wayEntry;
const vec3 wayRise = vec3(0.0);
vec3 toEye; // of unit length

vec3 gradientAt(float share)
{
  return gradientEntry;
}

void beginIsoPoint(vec3 gradient, float depth)
{
  gradientEntry = gradient;
  vec2 step = gl_FragCoord.xy - rayPixel;
  vec4 view = rayView[0] + step.x * rayView[1] + step.y * rayView[2];
  vec3 direction = vec3(view.zw, -1.0);
  wayEntry = vec3(view.xy, -rayDepths.x) + depth * direction;
  toEye = -normalize(direction);
}
