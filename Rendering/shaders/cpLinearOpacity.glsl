// Opacity as the triangle has it; of a part of the thickness that of this part.

float opacityOf(float opacity, float visible, float thickness, float depthToLength)
{
  bool whole = !(visible < 0.999999 * thickness);
  return whole ? opacity : 1.0 - pow(1.0 - clamp(opacity, 0.0, 1.0), visible / thickness);
}
