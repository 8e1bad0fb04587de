// Where the mesh begins and ends between slices. A slice that holds no sample has room for one such
// end, in one float: below all scalars, and the greater the farther an exit or the nearer an entry,
// so that blending to the maximum leaves the ends of all elements together.

const float empty = -16777216.0; // neither a sample nor an end
const float endSteps = 2047.0;
const float endBelow = -2.0; // scalars lie above -1

// share: of the slab between two slices; the scalar is wanted between -1/8 and 9/8.
float encodeEnd(bool isEntry, float share, float scalar)
{
  float place = floor(clamp(isEntry ? share : 1.0 - share, 0.0, 1.0) * endSteps + 0.5);
  float level = floor(clamp((scalar + 0.125) * 0.8, 0.0, 1.0) * endSteps + 0.5);
  return endBelow - ((isEntry ? 2048.0 : 0.0) + place) * 2048.0 - level;
}

// x: share, y: scalar.
vec2 decodeEnd(float code, out bool isEntry)
{
  float rest = endBelow - code;
  float place = floor(rest / 2048.0);
  isEntry = place >= 2048.0;
  float share = (place - (isEntry ? 2048.0 : 0.0)) / endSteps;
  float level = (rest - 2048.0 * place) / endSteps;
  return vec2(isEntry ? share : 1.0 - share, level * 1.25 - 0.125);
}

// What a slice outside of an element's passage, in slices, holds of its ends.
float endNear(float slice, vec2 passage, vec2 scalars)
{
  bool isExit = passage.y < slice && passage.y > slice - 1.0;
  bool isEntry = passage.x > slice && passage.x < slice + 1.0;
  float code = encodeEnd(isEntry, isEntry ? passage.x - slice : passage.y - slice + 1.0,
    isEntry ? scalars.x : scalars.y);
  return isExit || isEntry ? code : empty;
}
