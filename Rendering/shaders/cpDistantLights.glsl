// Phong's model on a point, as in cpLighting.glsl, of lights far away: what arrives is the same
// everywhere. After numberOfLights and hasHighlights. Colours include the material's coefficients.

uniform vec3 distantAmbient;
uniform vec3 distantLights[3 * numberOfLights + 1]; // to the light, diffuse, specular
uniform float distantPower;

vec3 shade(vec3 colour, float share)
{
  vec3 gradient = gradientAt(share);
  float size = length(gradient);
  vec3 normal = gradient / max(size, 1e-30);
  float facing = dot(normal, toEye);
  vec3 scattered = distantAmbient;
  vec3 mirrored = vec3(0.0);
  for (int i = 0; i < numberOfLights; ++i)
  {
    float cosine = dot(normal, distantLights[3 * i]);
    scattered += abs(cosine) * distantLights[3 * i + 1];
    if (hasHighlights)
    {
      float glance = 2.0 * cosine * facing - dot(distantLights[3 * i], toEye);
      float shine = size > 0.0 && glance > 0.0 ? pow(glance, distantPower) : 0.0;
      mirrored += shine * distantLights[3 * i + 2];
    }
  }
  return colour * scattered + mirrored;
}
