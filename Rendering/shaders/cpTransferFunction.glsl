// The transfer function: piecewise linear over the normalised scalar, steps as two nodes at one
// position (class TransferFunction). Interval i lies between node i and node i + 1.

uniform samplerBuffer nodePositions;
uniform samplerBuffer nodeValues; // rgb colour, a extinction per world length
uniform int numberOfNodes;

float nodePosition(int node)
{
  return texelFetch(nodePositions, node).r;
}

vec4 nodeValue(int node)
{
  return texelFetch(nodeValues, node);
}

// The interval that a segment starts in: the upper one of a node if the scalar rises or stays.
int firstInterval(float scalar, bool falls)
{
  int low = 0;
  int high = numberOfNodes - 1;
  while (high - low > 1)
  {
    int middle = (low + high) / 2;
    float position = nodePosition(middle);
    bool above = falls ? scalar > position : scalar >= position;
    low = above ? middle : low;
    high = above ? high : middle;
  }
  return low;
}

vec4 valueInInterval(int interval, float scalar)
{
  float below = nodePosition(interval);
  float width = nodePosition(interval + 1) - below;
  float weight = width > 0.0 ? clamp((scalar - below) / width, 0.0, 1.0) : 0.0;
  return mix(nodeValue(interval), nodeValue(interval + 1), weight);
}
