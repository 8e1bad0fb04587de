// Emission and absorption along a segment on which the scalar is linear.
// Inside an interval of the transfer function colour and extinction are linear in the scalar, hence
//   alpha = 1 - exp(-T), T the mean extinction times the length, exactly, and
//   colour = alpha * (colour at the absorption-weighted mean position), with that position by
//   Gauss quadrature over steps whose optical depth is at most 1.

const vec3 gaussNode = vec3(0.11270166537925831, 0.5, 0.88729833462074169);
const vec3 gaussWeight = vec3(0.27777777777777778, 0.44444444444444444, 0.27777777777777778);

// Premultiplied colour and alpha of a step; front and back are rgb and extinction.
vec4 integrateStep(vec4 front, vec4 back, float len)
{
  float depthFront = front.a * len;
  float depthRise = (back.a - front.a) * len;
  vec3 depth = gaussNode * (depthFront + 0.5 * depthRise * gaussNode);
  vec3 absorbed = gaussWeight * (depthFront + depthRise * gaussNode) * exp(-depth);
  float optical = depthFront + 0.5 * depthRise;
  float alpha = opacityOf(optical);
  float total = absorbed.x + absorbed.y + absorbed.z;
  float mean = total > 0.0 ? dot(absorbed, gaussNode) / total : 0.5;
  return vec4(mix(front.rgb, back.rgb, mean) * alpha, alpha);
}

// Adds a piece of one interval behind what `sum` holds already.
void addPiece(vec4 front, vec4 back, vec2 ends, float len, inout vec4 sum)
{
  // A thousand would do to be opaque: more would leave the range of a float when squared.
  float thinning = min(1.0, 1e6 / max(max(front.a, back.a) * len, 1.0));
  len *= thinning;
  for (int steps = 0; steps < 24 && len > 0.0 && sum.a < 0.9999999; ++steps)
  {
    float share = stepShare(front.a * len, (back.a - front.a) * len);
    vec4 middle = share < 1.0 ? mix(front, back, share) : back;
    sum += (1.0 - sum.a) * integrateStep(front, middle, share * len);
    len = share < 1.0 ? len * (1.0 - share) : 0.0;
    front = middle;
  }
}
