//VTK::System::Dec
//VTK::Output::Dec

// The window's depth of the nearest iso-surface where it is opaque.

uniform sampler2D layer;
uniform sampler2D layerDepth; // a share of the mesh's
uniform vec2 isoDepths;       // the least depth of the mesh and how deep it is
uniform vec4 depthFromWindow; // of a window depth z: (x + y z) / (z + w z)

in vec2 texCoord;

void main()
{
  if (texture(layer, texCoord).a < 0.999)
  {
    discard;
  }
  float depth = texture(layerDepth, texCoord).r * isoDepths.y + isoDepths.x;
  gl_FragData[0] = vec4(0.0);
  gl_FragDepth = (depthFromWindow.x - depth * depthFromWindow.z) /
    (depth * depthFromWindow.w - depthFromWindow.y);
}
