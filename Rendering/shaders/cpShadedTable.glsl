// A segment's emission and absorption from a table, with light and gradient opacity: in so many
// parts at least, and cut where these bend. Gradient opacity makes a part longer or shorter: what
// counts is extinction times length.

vec4 integrateSegment(float front, float back, float len)
{
  float steps = float(stepsOf(len));
  vec4 sum = vec4(0.0);
  vec2 share = vec2(0.0);
  for (int i = 0; i < 64 && share.x < 1.0 && sum.a < 0.9999999; ++i)
  {
    float next = (floor(share.x * steps + 1e-3) + 1.0) / steps;
    next = max(min(next, min(nextLight(share.x), nextGradientNode(share.x))), share.x + 0.004);
    share.y = i == 63 ? 1.0 : min(next, 1.0);
    float part = len * (share.y - share.x) * gradientOpacity(0.5 * (share.x + share.y));
    vec3 place = placeOf(mix(vec2(front), vec2(back), share), part);
    vec4 entry = texture(preIntegration, place);
    float alpha = opacityOf(entry.a * part);
    sum += (1.0 - sum.a) * vec4(litBy(place, entry.rgb, share) * alpha, alpha);
    share.x = share.y;
  }
  return sum;
}
