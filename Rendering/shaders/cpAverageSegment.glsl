// A segment's emission and absorption from the mean of colour and extinction at its ends.

vec4 valueAt(float scalar)
{
  return valueInInterval(firstInterval(scalar, false), scalar);
}

vec4 integrateSegment(float front, float back, float len)
{
  vec4 mean = 0.5 * (valueAt(front) + valueAt(back));
  float depth = mean.a * len;
  // The series keeps the digits that 1 - exp loses for thin segments.
  float alpha = depth < 0.01 ? depth * (1.0 - depth * (0.5 - depth / 6.0)) : 1.0 - exp(-depth);
  return vec4(mean.rgb * alpha, alpha);
}
