// The scalars of an element on slices.

const float empty = -16777216.0; // no sample

// On four slices at `depths`, empty outside of the element.
vec4 samplesAt(Ray ray, vec4 at, vec4 slope, vec4 depths)
{
  vec4 samples;
  for (int i = 0; i < 4; ++i)
  {
    float depth = depths[i];
    vec4 b = at + depth * slope;
    vec4 room = b + elementTolerance;
    bool isInside = min(min(room.x, room.y), min(room.z, room.w)) >= 0.0 &&
      depth >= ray.limits.x && depth <= ray.limits.y;
    b = max(b, 0.0);
    // Beyond [0,1] the transfer function is constant.
    samples[i] = isInside ? clamp(scalarOf(b / (b.x + b.y + b.z + b.w)), -1.0, 2.0) : empty;
  }
  return samples;
}
