// A segment's emission and absorption from the mean of colour and extinction at its ends.

vec4 valueAt(float scalar)
{
  return valueInInterval(firstInterval(scalar, false), scalar);
}

vec4 integrateSegment(float front, float back, float len)
{
  vec4 mean = 0.5 * (valueAt(front) + valueAt(back));
  float alpha = opacityOf(mean.a * len);
  return vec4(mean.rgb * alpha, alpha);
}
