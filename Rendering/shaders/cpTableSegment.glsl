// A segment's emission and absorption looked up in a table (class PreIntegrationTable).

uniform sampler3D preIntegration;
uniform vec4 tableLookUp; // least scalar, 1 / width, greatest extinction, greatest length
uniform int samplesPerSegment;

vec4 lookUp(float front, float back, float len)
{
  vec3 size = vec3(textureSize(preIntegration, 0));
  vec2 scalars = (vec2(front, back) - tableLookUp.x) * tableLookUp.y * (size.xy - 1.0);
  float share = (1.0 - exp2(-len * tableLookUp.z)) * size.z;
  vec4 entry = texture(preIntegration, (vec3(scalars, share) + 0.5) / size);
  float alpha = opacityOf(entry.a * len);
  return vec4(entry.rgb * alpha, alpha);
}

vec4 integrateSegment(float front, float back, float len)
{
  // Lengths beyond the table's are taken in steps.
  float needed = ceil(len * tableLookUp.z / tableLookUp.w);
  int steps = int(clamp(max(needed, float(samplesPerSegment)), 1.0, 16.0));
  vec4 sum = vec4(0.0);
  for (int i = 0; i < steps; ++i)
  {
    vec2 share = vec2(i, i + 1) / float(steps);
    vec2 ends = mix(vec2(front), vec2(back), share);
    sum += (1.0 - sum.a) * lookUp(ends.x, ends.y, len / float(steps));
  }
  return sum;
}
