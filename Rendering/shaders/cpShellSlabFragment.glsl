//VTK::System::Dec
//VTK::Output::Dec

// Fragment stage for pre-integration: as for points, but a slice without a sample holds where the
// element ends in the slab before it, or begins in the slab behind it (cpSlabEnd).

//VTK::Ray::Dec
//VTK::Element::Dec
//VTK::Scalar::Dec
//VTK::Passage::Dec
//VTK::SlabEnd::Dec
//VTK::Shell::Dec
//VTK::SliceDepths::Dec

void main()
{
  if (isHidden())
  {
    discard;
  }
  Ray ray = rayOfFragment();
  vec2 slices = sliceDepths(ray);
  vec4 at = barycentricAt(ray, slices.x);
  vec4 slope = barycentricOf(ray.direction) * slices.y;
  vec2 passage = passageOf(at, slope, elementTolerance, (ray.limits - slices.x) / slices.y);
  if (!(passage.y > passage.x) || passage.x > float(4 * NUMBER_OF_TARGETS) || passage.y < -1.0)
  {
    discard;
  }
  vec2 ends = vec2(scalarAt(at, slope, passage.x), scalarAt(at, slope, passage.y));
  vec4 samples[4] = vec4[4](vec4(empty), vec4(empty), vec4(empty), vec4(empty));
  for (int i = 0; i < 4 * NUMBER_OF_TARGETS; ++i)
  {
    float slice = float(i);
    samples[i / 4][i % 4] = slice >= passage.x && slice <= passage.y
      ? clamp(scalarAt(at, slope, slice), -1.0, 2.0) : endNear(slice, passage, ends);
  }
  // Those beyond the targets go nowhere.
  gl_FragData[0] = samples[0];
  gl_FragData[1] = samples[1];
  gl_FragData[2] = samples[2];
  gl_FragData[3] = samples[3];
}
