// Where a ray is inside an element, in steps of its own: b = at + step * slope.

float scalarAt(vec4 at, vec4 slope, float step)
{
  vec4 b = max(at + step * slope, 0.0);
  return scalarOf(b / (b.x + b.y + b.z + b.w));
}

// Entry and exit, in steps; coordinates down to -tolerance count as inside.
vec2 passageOf(vec4 at, vec4 slope, vec4 tolerance, vec2 limits)
{
  vec2 passage = limits;
  for (int i = 0; i < 4; ++i)
  {
    float step = -(at[i] + tolerance[i]) / slope[i];
    passage.x = slope[i] > 0.0 ? max(passage.x, step) : passage.x;
    passage.y = slope[i] < 0.0 ? min(passage.y, step) : passage.y;
    passage.y = slope[i] == 0.0 && at[i] < -tolerance[i] ? passage.x : passage.y;
  }
  return passage;
}
