// The gradient opacity: piecewise linear over the gradient's length, steps as two nodes at one
// position.

uniform samplerBuffer gradientNodes; // position and opacity of each in turn
uniform int numberOfGradientNodes;
uniform float gradientScale; // of the view's gradient: its position

float gradientOpacity(float share)
{
  float position = gradientScale * length(gradientAt(share));
  int low = 0;
  int high = numberOfGradientNodes - 1;
  while (high - low > 1)
  {
    int middle = (low + high) / 2;
    bool above = position >= texelFetch(gradientNodes, 2 * middle).r;
    low = above ? middle : low;
    high = above ? high : middle;
  }
  float below = texelFetch(gradientNodes, 2 * low).r;
  float width = texelFetch(gradientNodes, 2 * low + 2).r - below;
  float weight = width > 0.0 ? clamp((position - below) / width, 0.0, 1.0) : 0.0;
  float opacity = texelFetch(gradientNodes, 2 * low + 1).r;
  return mix(opacity, texelFetch(gradientNodes, 2 * low + 3).r, weight);
}

// The share at which the gradient has next the length of a node, or its least.
float nextGradientNode(float share)
{
  float squared = dot(gradientRise, gradientRise);
  float next = 1.0;
  float after = share + 1e-4;
  if (squared > 0.0)
  {
    float nearest = -dot(gradientEntry, gradientRise) / squared;
    vec3 least = gradientScale * gradientAt(nearest);
    next = nearest > after ? min(next, nearest) : next;
    for (int i = 1; i + 1 < numberOfGradientNodes; ++i)
    {
      float position = texelFetch(gradientNodes, 2 * i).r;
      float apart = position * position - dot(least, least);
      float way = sqrt(max(apart, 0.0) / squared) / gradientScale;
      next = apart > 0.0 && nearest - way > after ? min(next, nearest - way) : next;
      next = apart > 0.0 && nearest + way > after ? min(next, nearest + way) : next;
    }
  }
  return next;
}
