// The emission of a segment as the mean of that at both ends, as the paper takes it.

vec3 emissionAt(float scalar)
{
  vec4 value = valueInInterval(firstInterval(scalar, false), scalar);
  return value.a * value.rgb;
}

vec4 integrateSegment(float front, float back, float len)
{
  return vec4(0.5 * len * (emissionAt(front) + emissionAt(back)), 0.0);
}
