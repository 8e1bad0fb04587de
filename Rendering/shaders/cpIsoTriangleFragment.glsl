//VTK::System::Dec
//VTK::Output::Dec

// Where a fragment's ray meets the plane of its triangle: the rasteriser's own depth is that of
// another ray, for it moves corners to a 256th of a pixel.
// Output: lit colour; depth as fragmentDepth has it.

uniform samplerBuffer trianglePoints;  // mesh coordinates; w 0: not finite
uniform isamplerBuffer triangleCorners; // three points per triangle
uniform int firstTriangle;
uniform vec4 meshToDepth;   // depth of a point in mesh coordinates
uniform vec4 fragmentDepth; // of a depth d: (x + y d) / (z + w d)
uniform vec3 isoColour;

//VTK::Ray::Dec
//VTK::Gradient::Dec
//VTK::IsoPoint::Dec
//VTK::Lighting::Dec

// Below the near plane where the triangle has none.
float depthOnTriangle(Ray ray)
{
  ivec4 ids = texelFetch(triangleCorners, firstTriangle + gl_PrimitiveID);
  vec3 corner[3];
  vec3 depths;
  bool isFinite = true;
  for (int i = 0; i < 3; ++i)
  {
    vec4 point = texelFetch(trianglePoints, ids[i]);
    isFinite = isFinite && point.w > 0.0;
    corner[i] = point.xyz;
    depths[i] = dot(meshToDepth, vec4(point.xyz, 1.0));
  }
  if (!isFinite)
  {
    return ray.limits.x - 1.0;
  }
  vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
  float rise = dot(normal, ray.direction);
  float depth = rise == 0.0 ? depths.x : dot(normal, corner[0] - ray.point) / rise;
  // Seen edge-on, a plane leaves its triangle within the pixel.
  return clamp(depth, min(min(depths.x, depths.y), depths.z), max(max(depths.x, depths.y), depths.z));
}

void main()
{
  Ray ray = rayOfFragment();
  float depth = depthOnTriangle(ray);
  if (!(depth >= ray.limits.x && depth < ray.limits.y))
  {
    discard;
  }
  //VTK::IsoPoint::Impl
  gl_FragData[0] = vec4(shade(isoColour, 0.0), 1.0);
  gl_FragDepth =
    (fragmentDepth.x + depth * fragmentDepth.y) / (fragmentDepth.z + depth * fragmentDepth.w);
}
