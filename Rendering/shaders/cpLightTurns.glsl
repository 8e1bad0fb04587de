// Up to where light along the way is smooth enough for a few Gauss nodes.

uniform float greatestTurn; // the tangent of the angle that the gradient turns by in one step

// The share at which the gradient has turned by the angle: it moves along a line that passes zero
// at a distance. 1 where it does not turn so far.
float nextTurn(float share)
{
  vec3 here = gradientAt(share);
  vec3 last = gradientAt(1.0);
  if (dot(here, last) > 0.0 && length(cross(here, last)) <= greatestTurn * dot(here, last))
  {
    return 1.0;
  }
  float squared = dot(gradientRise, gradientRise);
  float nearest = -dot(gradientEntry, gradientRise) / squared;
  float radius = length(gradientAt(nearest)) * inversesqrt(squared);
  float from = share - nearest;
  float room = radius - from * greatestTurn;
  return room > 0.0 ? nearest + radius * (from + radius * greatestTurn) / room : 1.0;
}

// The next share at which a + b t + c t t is zero.
float nextRoot(vec3 f, float share)
{
  float inner = f.y * f.y - 4.0 * f.x * f.z;
  float q = -0.5 * (f.y + (f.y < 0.0 ? -1.0 : 1.0) * sqrt(max(inner, 0.0)));
  vec2 roots = inner < 0.0 ? vec2(1.0) : vec2(q / f.z, f.x / q);
  return min(roots.x > share + 1e-4 ? roots.x : 1.0, roots.y > share + 1e-4 ? roots.y : 1.0);
}

// The share at which the mirror image of a light passes from behind the eye before it.
float nextGlance(vec3 way, float share)
{
  vec2 side = vec2(dot(gradientEntry, way), dot(gradientRise, way));
  vec2 seen = vec2(dot(gradientEntry, toEye), dot(gradientRise, toEye));
  vec3 product = vec3(side.x * seen.x, side.x * seen.y + side.y * seen.x, side.y * seen.y);
  vec3 square = vec3(dot(gradientEntry, gradientEntry), 2.0 * dot(gradientEntry, gradientRise),
    dot(gradientRise, gradientRise));
  return nextRoot(2.0 * product - dot(way, toEye) * square, share);
}
