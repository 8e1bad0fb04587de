//VTK::System::Dec
//VTK::Output::Dec

// Blending stage for pre-integration: the slabs between neighbouring slices, the first one from the
// last slice of the shell before, the ends of the mesh where they are.
// Output: premultiplied colour and alpha, to be blended below what lies before.

//VTK::Slices::Dec
//VTK::SlabEnd::Dec
//VTK::TransferFunction::Dec
//VTK::Integral::Dec
//VTK::Segment::Dec

uniform vec3 shell;           // y: length of a slab in the world
uniform sampler2D lastSlices; // of the shell before: w is its last slice
uniform int isFirstShell;

// Place within the slab and scalar where its front, or back, slice lets it begin, or end.
bool findEnd(float slice, bool atFront, out vec2 end)
{
  if (slice > -1.5)
  {
    end = vec2(atFront ? 0.0 : 1.0, slice);
    return true;
  }
  bool isEntry;
  end = decodeEnd(slice, isEntry);
  return slice > empty && isEntry == atFront;
}

void main()
{
  vec4 sum = vec4(0.0);
  float front = isFirstShell != 0 ? empty : texture(lastSlices, texCoord).w;
  for (int i = 0; i < 4 * NUMBER_OF_TARGETS; ++i)
  {
    float back = sliceAt(i);
    vec2 begin, end;
    if (findEnd(front, true, begin) && findEnd(back, false, end) && end.x > begin.x)
    {
      vec4 slab = integrateSegment(begin.y, end.y, (end.x - begin.x) * shell.y);
      sum += (1.0 - sum.a) * slab;
    }
    front = back;
  }
  if (sum.a == 0.0)
  {
    discard;
  }
  gl_FragData[0] = sum;
}
