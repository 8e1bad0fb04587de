//VTK::System::Dec
//VTK::Output::Dec

// One tetrahedron in one pixel: entry and exit from the cell's planes, then the exact integral.
// Output: premultiplied colour and alpha, float, to be blended from back to front.

flat in vec3 anchorFirst;
flat in vec3 anchorSecond;
flat in vec3 faceNormal[4];
flat in vec4 inverseHeight;
flat in vec4 cornerScalars;

const vec3 nudge = vec3(0.6180340, 0.4142136, 0.2360680); // along no face of a tidy mesh

//VTK::Ray::Dec
//VTK::TransferFunction::Dec
//VTK::Integral::Dec
//VTK::Segment::Dec

float scalarAt(vec4 value, vec4 slope, float depth)
{
  vec4 barycentric = max(value + depth * slope, 0.0) * abs(inverseHeight);
  return clamp(dot(barycentric, cornerScalars) / dot(barycentric, vec4(1.0)), 0.0, 1.0);
}

void main()
{
  Ray ray = rayOfFragment();
  // Signs change no digit: what one cell finds on a shared face, its neighbour finds negated.
  vec4 inward = sign(inverseHeight);
  vec4 value, slope;
  for (int i = 0; i < 4; ++i)
  {
    vec3 offset = ray.point - (i == 0 ? anchorSecond : anchorFirst);
    value[i] = inward[i] * dot(faceNormal[i], offset);
    slope[i] = inward[i] * dot(faceNormal[i], ray.direction);
  }
  vec4 depth = -value / slope;
  float entry = ray.limits.x;
  float exit = ray.limits.y;
  for (int i = 0; i < 4; ++i)
  {
    entry = slope[i] > 0.0 ? max(entry, depth[i]) : entry;
    exit = slope[i] < 0.0 ? min(exit, depth[i]) : exit;
    // A ray inside a face counts as moved a little, all rays to the same side: it sees one of the
    // face's two cells, and the cells it sees follow each other through faces, in their order.
    float side = value[i] != 0.0 ? value[i] : inward[i] * dot(faceNormal[i], nudge);
    exit = slope[i] == 0.0 && side < 0.0 ? entry : exit;
  }
  // A flat cell has no height and no volume.
  if (!(exit > entry) || inverseHeight[0] == 0.0)
  {
    discard;
  }
  float front = scalarAt(value, slope, entry);
  float back = scalarAt(value, slope, exit);
  gl_FragData[0] = integrateSegment(front, back, (exit - entry) * ray.depthToLength);
}
