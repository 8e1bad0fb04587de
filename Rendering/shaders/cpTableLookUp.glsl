// A segment looked up in a table of emission and absorption (class PreIntegrationTable).

uniform sampler3D preIntegration;
uniform vec4 tableLookUp; // least scalar, 1 / width, greatest extinction, greatest length
uniform int samplesPerSegment;

// The place in the table of a segment between two scalars.
vec3 placeOf(vec2 scalars, float len)
{
  vec3 size = vec3(textureSize(preIntegration, 0));
  vec2 place = (scalars - tableLookUp.x) * tableLookUp.y * (size.xy - 1.0);
  float share = (1.0 - exp2(-len * tableLookUp.z)) * size.z;
  return (vec3(place, share) + 0.5) / size;
}

// Lengths beyond the table's are taken in steps.
int stepsOf(float len)
{
  float needed = ceil(len * tableLookUp.z / tableLookUp.w);
  return int(clamp(max(needed, float(samplesPerSegment)), 1.0, 16.0));
}
