// Opacity of an extinction over the visible thickness, taken in each fragment.

float opacityOf(float extinction, float visible, float thickness, float depthToLength)
{
  float depth = extinction * visible * depthToLength;
  // The series keeps the digits that 1 - exp loses for thin cells.
  return depth < 0.01 ? depth * (1.0 - depth * (0.5 - depth / 6.0)) : 1.0 - exp(-depth);
}
