// Light on a segment of a table. The paper takes the diffuse light at the segment's ends and one
// highlight where the segment is seen most; here both are taken at two places, as far to either
// side of there as the segment is seen deep: for light that is linear that is the same, for other
// light it is exact up to the third power.

uniform sampler3D preIntegrationFront; // diffuse colour by the front's light; w
uniform sampler3D preIntegrationBack;  // diffuse colour by the back's light; spread of w

vec3 litBy(vec3 place, vec3 colour, vec2 share)
{
  vec4 front = texture(preIntegrationFront, place);
  float spread = max(texture(preIntegrationBack, place).a, 1e-3);
  vec2 ahead = clamp(front.a + vec2(spread, -spread), 0.0, 1.0);
  Light near = lightAt(mix(share.y, share.x, ahead.x));
  Light far = lightAt(mix(share.y, share.x, ahead.y));
  vec3 slope = (near.ambient + near.diffuse - far.ambient - far.diffuse) / (ahead.x - ahead.y);
  vec3 level = near.ambient + near.diffuse - ahead.x * slope;
  return colour * level + front.rgb * slope + 0.5 * (near.highlight + far.highlight);
}
