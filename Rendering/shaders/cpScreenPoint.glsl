// Points in clip coordinates on the screen, in pixels of the viewport.

uniform vec2 viewportSize;

// Kept within surroundings of the viewport in which a float still tells pixels apart.
const float surroundings = 64.0;

vec2 pixelOf(vec4 clip)
{
  vec2 ndc = clamp(clip.xy / max(clip.w, 1e-30), -surroundings, surroundings);
  return (ndc * 0.5 + 0.5) * viewportSize;
}

bool isBehindNearPlane(vec4 clip)
{
  return clip.z < -clip.w;
}

// Only an upright box holds what is kept within the surroundings.
bool needsBox(vec4 clip)
{
  return isBehindNearPlane(clip) || max(abs(clip.x), abs(clip.y)) > surroundings * clip.w;
}
