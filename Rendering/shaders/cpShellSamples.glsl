// The scalars of an element on slices.

const float empty = -16777216.0; // no sample

// The scalars on four slices at `depths`, empty outside of the element.
vec4 samplesAt(Ray ray, vec4 at, vec4 slope, vec4 depths)
{
  vec4 least = vec4(0.0);
  vec4 sum = vec4(0.0);
  vec4 scalar = vec4(0.0);
  for (int i = 0; i < 4; ++i)
  {
    vec4 b = at[i] + slope[i] * depths;
    least = min(least, b + elementTolerance[i]);
    b = max(b, 0.0);
    sum += b;
    scalar += b * elementScalars[i];
  }
  // Beyond [0,1] the transfer function is constant.
  scalar = clamp(scalar / sum, -1.0, 2.0);
  vec4 outside = max(max(ray.limits.x - depths, depths - ray.limits.y), -least);
  return mix(scalar, vec4(empty), greaterThan(outside, vec4(0.0)));
}
