//VTK::System::Dec
//VTK::Output::Dec

// The nearest point behind the last layer where an element's scalar is one of the iso-values.
// Output: premultiplied lit colour; depth as a share of the mesh's.

flat in ivec4 elementIds;

uniform float isoValues[16]; // normalised
uniform int numberOfIsoValues;
uniform vec2 isoDepths; // the least depth of the mesh and how deep it is
uniform sampler2D lastLayer;
uniform int isFirstLayer;

//VTK::Ray::Dec
//VTK::Element::Dec
//VTK::TransferFunction::Dec
//VTK::IsoPoint::Dec
//VTK::GradientOpacity::Dec
//VTK::Lighting::Dec

void main()
{
  Ray ray = rayOfFragment();
  vec4 at, slope;
  float base = beside(ray, at, slope);
  vec2 limits = ray.limits - base;
  if (isFirstLayer == 0)
  {
    // Two elements may find the same point of their common face, but for rounding.
    float last = texelFetch(lastLayer, ivec2(gl_FragCoord.xy), 0).r + 4e-6;
    limits.x = max(limits.x, last * isoDepths.y + isoDepths.x - base);
  }
  float rise = dot(slope, elementScalars - elementScalars.x);
  vec2 found = vec2(limits.y, 2.0); // depth, and a value above all
  for (int i = 0; i < numberOfIsoValues; ++i)
  {
    float depth = -dot(at, elementScalars - isoValues[i]) / rise;
    vec4 b = at + depth * slope + elementTolerance;
    bool isInside = min(min(b.x, b.y), min(b.z, b.w)) >= 0.0;
    found = isInside && depth >= limits.x && depth < found.x ? vec2(depth, float(i) + 3.0) : found;
  }
  if (found.y < 3.0)
  {
    discard;
  }
  float value = isoValues[int(found.y) - 3];
  vec4 colour = valueInInterval(firstInterval(value, false), value);
  //VTK::IsoPoint::Impl
  float alpha = min(colour.a, 1.0) * gradientOpacity(0.0);
  gl_FragData[0] = vec4(shade(colour.rgb, 0.0) * alpha, alpha);
  gl_FragDepth = (base + found.x - isoDepths.x) / isoDepths.y;
}
