// A segment's emission and absorption from the mean of colour and extinction at its ends, with
// light and gradient opacity there.

vec4 shadedAt(float scalar, float share)
{
  vec4 value = valueInInterval(firstInterval(scalar, false), scalar);
  return vec4(shade(baseColour(value.rgb, share), share), value.a * gradientOpacity(share));
}

vec4 integrateSegment(float front, float back, float len)
{
  vec4 mean = 0.5 * (shadedAt(front, 0.0) + shadedAt(back, 1.0));
  float alpha = opacityOf(mean.a * len);
  return vec4(mean.rgb * alpha, alpha);
}
