// Emission and absorption along a segment with light and gradient opacity: Gauss quadrature over
// steps of an optical depth of at most about 1, in which the light is smooth.

const vec3 gaussNode = vec3(0.11270166537925831, 0.5, 0.88729833462074169);
const vec3 gaussWeight = vec3(0.27777777777777778, 0.44444444444444444, 0.27777777777777778);
// From values at the nodes to the integrals up to them.
const mat3 running = mat3(0.13888889, 0.30026320, 0.26798833, -0.03597667, 0.22222222, 0.48042111,
  0.00978944, -0.02248542, 0.13888889);

void addStep(vec4 front, vec4 back, vec2 ends, float len, inout vec4 sum)
{
  vec3 depth;
  mat3 colours;
  for (int i = 0; i < 3; ++i)
  {
    vec4 value = mix(front, back, gaussNode[i]);
    float share = mix(ends.x, ends.y, gaussNode[i]);
    depth[i] = value.a * gradientOpacity(share) * len;
    colours[i] = shade(baseColour(value.rgb, share), share);
  }
  vec3 absorbed = gaussWeight * depth * exp(-(running * depth));
  float total = absorbed.x + absorbed.y + absorbed.z;
  float alpha = opacityOf(dot(gaussWeight, depth));
  vec3 colour = total > 0.0 ? colours * absorbed / total : vec3(0.0);
  sum += (1.0 - sum.a) * vec4(alpha * colour, alpha);
}

// A stretch in which light and gradient opacity are smooth.
void addStretch(vec4 front, vec4 back, vec2 ends, float len, inout vec4 sum)
{
  // Beside the ends: at a step of the gradient opacity they are on either side.
  vec2 depths = len * vec2(front.a * gradientOpacity(mix(ends.x, ends.y, 0.02)),
    back.a * gradientOpacity(mix(ends.x, ends.y, 0.98)));
  float done = 0.0;
  for (int steps = 0; steps < 24 && done < 1.0 && sum.a < 0.9999999; ++steps)
  {
    float left = 1.0 - done;
    float here = mix(depths.x, depths.y, done);
    float share = stepShare(here * left, (depths.y - here) * left);
    float next = share < 1.0 ? done + share * left : 1.0;
    addStep(mix(front, back, done), mix(front, back, next), mix(ends.xx, ends.yy, vec2(done, next)),
      (next - done) * len, sum);
    done = next;
  }
}
