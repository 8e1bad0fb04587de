// A piece of one interval of the transfer function, cut where light or gradient opacity bend.

// Adds it behind what `sum` holds already.
void addPiece(vec4 front, vec4 back, vec2 ends, float len, inout vec4 sum)
{
  // A thousand would do to be opaque: more would leave the range of a float when squared.
  float thinning = min(1.0, 1e6 / max(max(front.a, back.a) * len, 1.0));
  float width = ends.y - ends.x;
  float done = front.a + back.a > 0.0 && width > 0.0 ? ends.x : ends.y;
  for (int turns = 0; turns < 32 && done < ends.y && sum.a < 0.9999999; ++turns)
  {
    float next = min(min(nextLight(done), nextGradientNode(done)), nextColour(done));
    next = max(next, done + 0.004);
    next = turns == 31 ? ends.y : min(next, ends.y);
    vec2 shares = (vec2(done, next) - ends.x) / width;
    addStretch(mix(front, back, shares.x), mix(front, back, shares.y), vec2(done, next),
      (shares.y - shares.x) * len * thinning, sum);
    done = next;
  }
}
