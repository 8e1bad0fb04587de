//VTK::System::Dec
//VTK::Output::Dec

// Fragment stage: the scalars of one element on the slices of a shell, four to a target, to be
// blended to their maximum. No two elements hold the same sample but on their common face.

//VTK::Ray::Dec
//VTK::Element::Dec
//VTK::Scalar::Dec
//VTK::Shell::Dec
//VTK::SliceDepths::Dec
//VTK::Samples::Dec

void main()
{
  if (isHidden())
  {
    discard;
  }
  Ray ray = rayOfFragment();
  vec2 slices = sliceDepths(ray);
  vec4 at = barycentricAt(ray, slices.x);
  vec4 slope = barycentricOf(ray.direction);
  ray.limits -= slices.x;
  vec4 samples[4] = vec4[4](vec4(empty), vec4(empty), vec4(empty), vec4(empty));
  vec4 found = vec4(empty);
  for (int i = 0; i < NUMBER_OF_TARGETS; ++i)
  {
    samples[i] = samplesAt(ray, at, slope, (vec4(0.0, 1.0, 2.0, 3.0) + float(4 * i)) * slices.y);
    found = max(found, samples[i]);
  }
  if (max(max(found.x, found.y), max(found.z, found.w)) == empty)
  {
    discard;
  }
  // Those beyond the targets go nowhere.
  gl_FragData[0] = samples[0];
  gl_FragData[1] = samples[1];
  gl_FragData[2] = samples[2];
  gl_FragData[3] = samples[3];
}
