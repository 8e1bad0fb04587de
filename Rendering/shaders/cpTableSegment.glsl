// A segment's emission and absorption from a table.

vec4 integrateSegment(float front, float back, float len)
{
  int steps = stepsOf(len);
  float part = len / float(steps);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < steps; ++i)
  {
    vec2 share = vec2(i, i + 1) / float(steps);
    vec4 entry = texture(preIntegration, placeOf(mix(vec2(front), vec2(back), share), part));
    float alpha = opacityOf(entry.a * part);
    sum += (1.0 - sum.a) * vec4(entry.rgb * alpha, alpha);
  }
  return sum;
}
