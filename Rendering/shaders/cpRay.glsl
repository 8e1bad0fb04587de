// The ray of a fragment and the depths between which the scene lets it pass.
// Depths count along the view axis from the plane through the mesh's centre (class ViewRays).

uniform vec2 rayPixel;
uniform vec3 rayPoint[3];     // at rayPixel; change per pixel in x; in y
uniform vec3 rayDirection[3];
uniform vec3 rayWorld[3];     // the direction in the world
uniform vec4 rayView[3];      // the same in view coordinates: xy point, zw direction
uniform vec3 rayDepths;       // reference plane from the eye; near and far from the reference
uniform vec4 depthFromWindow;
uniform sampler2D opaqueDepth;
uniform int numberOfClippingPlanes;
uniform vec4 clippingPlanes[6]; // view coordinates: xyz normal, w offset; the positive side stays

struct Ray
{
  vec3 point;
  vec3 direction;
  float depthToLength;
  vec2 limits; // depths of begin and end
};

void stopAtOpaque(inout vec2 limits)
{
  float z = texelFetch(opaqueDepth, ivec2(gl_FragCoord.xy), 0).r;
  float opaque = (depthFromWindow.x + depthFromWindow.y * z) / (depthFromWindow.z + depthFromWindow.w * z);
  limits.y = z < 1.0 ? opaque : limits.y;
}

void clipRay(vec4 view, inout vec2 limits)
{
  for (int i = 0; i < numberOfClippingPlanes; ++i)
  {
    vec3 normal = clippingPlanes[i].xyz;
    float value = dot(normal, vec3(view.xy, -rayDepths.x)) + clippingPlanes[i].w;
    float slope = dot(normal, vec3(view.zw, -1.0));
    float depth = -value / slope;
    limits.x = slope > 0.0 ? max(limits.x, depth) : limits.x;
    limits.y = slope < 0.0 ? min(limits.y, depth) : limits.y;
    limits.y = slope == 0.0 && value < 0.0 ? limits.x : limits.y;
  }
}

Ray rayOfFragment()
{
  vec2 step = gl_FragCoord.xy - rayPixel;
  vec4 view = rayView[0] + step.x * rayView[1] + step.y * rayView[2];
  Ray ray;
  ray.point = rayPoint[0] + step.x * rayPoint[1] + step.y * rayPoint[2];
  ray.direction = rayDirection[0] + step.x * rayDirection[1] + step.y * rayDirection[2];
  ray.depthToLength = length(rayWorld[0] + step.x * rayWorld[1] + step.y * rayWorld[2]);
  ray.limits = rayDepths.yz;
  //VTK::OpaqueDepth::Impl
  //VTK::ClipRay::Impl
  return ray;
}
