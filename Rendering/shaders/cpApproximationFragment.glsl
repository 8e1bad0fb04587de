//VTK::System::Dec
//VTK::Output::Dec

// A triangle that stands for a cell in one pixel. Of its thickness counts what lies within the
// scene's limits: near and far plane, opaque depth, clipping planes.

in vec2 depthsVSOutput; // where the cell begins; its thickness
in vec4 valueVSOutput;

//VTK::Ray::Dec
//VTK::Opacity::Dec

// The thickness between the limits. A cell without thickness is a point.
float visibleThickness(vec2 limits)
{
  float front = max(depthsVSOutput.x, limits.x);
  float back = min(depthsVSOutput.x + depthsVSOutput.y, limits.y);
  return clamp(back - front, 0.0, depthsVSOutput.y);
}

void main()
{
  Ray ray = rayOfFragment();
  if (depthsVSOutput.x > ray.limits.y || depthsVSOutput.x + depthsVSOutput.y < ray.limits.x)
  {
    discard;
  }
  float thickness = visibleThickness(ray.limits);
  float opacity = opacityOf(valueVSOutput.a, thickness, depthsVSOutput.y, ray.depthToLength);
  gl_FragData[0] = vec4(valueVSOutput.rgb * opacity, opacity);
}
