// Without a gradient opacity.

float gradientOpacity(float share)
{
  return 1.0;
}

float nextGradientNode(float share)
{
  return 1.0;
}
