//VTK::System::Dec
//VTK::Output::Dec

// Where a fragment's ray meets the plane of its triangle: the rasteriser's own depth is that of
// another ray, for it moves corners to a 256th of a pixel.
// Output: lit colour; depth as fragmentDepth has it.

uniform vec4 fragmentDepth; // of a depth d: (x + y d) / (z + w d)
uniform vec3 isoColour;

flat in vec4 planeAbove; // as in cpIsoTriangleVertex.glsl
flat in vec4 planeRise;

//VTK::Ray::Dec
//VTK::Gradient::Dec
//VTK::IsoPoint::Dec
//VTK::Lighting::Dec

float depthOnTriangle()
{
  vec3 step = vec3(1.0, gl_FragCoord.xy - rayPixel);
  float rise = dot(planeRise.xyz, step);
  float depth = rise == 0.0 ? planeAbove.w : dot(planeAbove.xyz, step) / rise;
  // Seen edge-on, a plane leaves its triangle within the pixel.
  return min(max(depth, planeAbove.w), planeRise.w);
}

void main()
{
  Ray ray = rayOfFragment();
  float depth = depthOnTriangle();
  if (!(depth >= ray.limits.x && depth < ray.limits.y))
  {
    discard;
  }
  //VTK::IsoPoint::Impl
  gl_FragData[0] = vec4(shade(isoColour, 0.0), 1.0);
  gl_FragDepth =
    (fragmentDepth.x + depth * fragmentDepth.y) / (fragmentDepth.z + depth * fragmentDepth.w);
}
