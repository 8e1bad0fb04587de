//VTK::System::Dec
//VTK::Output::Dec

// Where the ray enters one tetrahedron, if that is before the layer behind; blended to the maximum:
// the next layer's depth.

flat in int cell;

uniform sampler2D layerBehind;

//VTK::Ray::Dec
//VTK::Clip::Dec

void main()
{
  Ray ray = rayOfFragment();
  vec4 texels[6];
  fetchCell(cell, texels);
  Crossing c = crossingOf(texels, ray.point, ray.direction, ray.limits);
  float behind = texelFetch(layerBehind, ivec2(gl_FragCoord.xy), 0).r;
  if (!(c.depth.y > c.depth.x) || c.inverseHeight[0] == 0.0 || !(c.depth.x < behind))
  {
    discard;
  }
  gl_FragData[0] = vec4(c.depth.x);
}
