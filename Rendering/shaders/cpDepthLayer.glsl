// Cells that hide each other in a circle are drawn in layers, from back to front (class DepthLayers).
// A layer has the cells that the ray enters from its depth on, up to the layer behind it: every cell
// is in one layer and one only, though two entries be equal or differ in a last digit between the
// program that finds the layers and the one that draws them.

uniform sampler2D thisLayer;
uniform sampler2D layerBehind;

bool isInLayer(float entry)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  return entry >= texelFetch(thisLayer, pixel, 0).r && entry < texelFetch(layerBehind, pixel, 0).r;
}
