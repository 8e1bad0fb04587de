//VTK::System::Dec
//VTK::Output::Dec

// Blending stage: the samples of a shell are classified and composited from front to back.
// Output: premultiplied colour and alpha, to be blended below what lies before.

//VTK::Slices::Dec
//VTK::TransferFunction::Dec

uniform vec3 shell; // y: distance of two slices

void main()
{
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4 * NUMBER_OF_TARGETS; ++i)
  {
    float scalar = sliceAt(i);
    if (scalar > -1.5)
    {
      vec4 value = valueInInterval(firstInterval(scalar, false), scalar);
      float depth = value.a * shell.y;
      // The series keeps the digits that 1 - exp loses for thin slabs.
      float alpha = depth < 0.01 ? depth * (1.0 - depth * (0.5 - depth / 6.0)) : 1.0 - exp(-depth);
      sum += (1.0 - sum.a) * vec4(value.rgb * alpha, alpha);
    }
  }
  if (sum.a == 0.0)
  {
    discard;
  }
  gl_FragData[0] = sum;
}
