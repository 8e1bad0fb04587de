// Splits a segment at the transfer function's nodes and integrates it from front to back.

vec4 integrateSegment(float front, float back, float len)
{
  bool falls = back < front;
  int interval = firstInterval(front, falls);
  vec4 value = valueInInterval(interval, front);
  vec4 sum = vec4(0.0);
  float done = 0.0;
  // A segment crosses each node once at most.
  for (int piece = 0; piece < numberOfNodes; ++piece)
  {
    float edge = nodePosition(falls ? interval : interval + 1);
    bool inner = falls ? interval > 0 && edge > back : interval + 2 < numberOfNodes && edge < back;
    float share = inner ? clamp((edge - front) / (back - front), done, 1.0) : 1.0;
    vec4 end = inner ? nodeValue(falls ? interval : interval + 1) : valueInInterval(interval, back);
    addPiece(value, end, vec2(done, share), (share - done) * len, sum);
    if (!inner)
    {
      break;
    }
    done = share;
    interval += falls ? -1 : 1;
    value = nodeValue(falls ? interval + 1 : interval);
  }
  return sum;
}
