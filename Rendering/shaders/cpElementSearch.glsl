//VTK::System::Dec
//VTK::Output::Dec

// Where the ray enters one element, if that is before the layer behind; blended to the maximum: the
// next layer's depth (class DepthLayers).

uniform sampler2D layerBehind;

//VTK::Ray::Dec
//VTK::Element::Dec
//VTK::Scalar::Dec
//VTK::Passage::Dec
//VTK::Crossing::Dec

void main()
{
  Ray ray = rayOfFragment();
  float base;
  vec4 at, slope;
  vec2 passage = crossElement(ray, base, at, slope);
  float behind = texelFetch(layerBehind, ivec2(gl_FragCoord.xy), 0).r;
  if (!(passage.y > passage.x) || !(base + passage.x < behind))
  {
    discard;
  }
  gl_FragData[0] = vec4(base + passage.x);
}
