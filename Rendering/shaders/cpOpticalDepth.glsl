// What an optical depth hides, and how far one of 1 reaches.

float opacityOf(float depth)
{
  // The series keeps the digits that 1 - exp loses for thin steps.
  return depth < 0.01 ? depth * (1.0 - depth * (0.5 - depth * (1.0 / 6.0 - depth / 24.0)))
                      : 1.0 - exp(-depth);
}

// The share of a piece after which the optical depth reaches 1, or the whole of it.
float stepShare(float depthFront, float depthRise)
{
  float root = depthFront * depthFront + 2.0 * depthRise;
  return root > 0.0 ? min(1.0, 2.0 / (depthFront + sqrt(root))) : 1.0;
}
