// The slices of a shell along a fragment's ray: samples at equal distances from the eye, in world
// lengths along the ray. Every element at a pixel finds the same depths.

uniform vec3 shell; // distance of the first slice, less that of the reference plane along rayWorld[0];
                    // spacing; depth of the eye from that plane

// Depth of the first slice, and the step to the next. The eye may be far: distances are compared
// with those of the ray in the middle, which leaves small numbers only.
vec2 sliceDepths(Ray ray)
{
  vec2 step = gl_FragCoord.xy - rayPixel;
  vec3 aside = step.x * rayWorld[1] + step.y * rayWorld[2];
  float longer = dot(aside, 2.0 * rayWorld[0] + aside) / (ray.depthToLength + length(rayWorld[0]));
  return vec2(shell.x + shell.z * longer, shell.y) / ray.depthToLength;
}
