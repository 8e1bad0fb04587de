// The bounds of a convex cell's projection in four directions on the screen: along an axis, at right
// angles to it, and along both diagonals between.

uniform isamplerBuffer cellHeaders; // first texel, planes + 65536 pairs, first corner, corners
uniform isamplerBuffer cornerIds;
uniform samplerBuffer points;
uniform mat4 meshToClip;

struct Bounds
{
  vec4 low;
  vec4 high;
};

vec4 clipOf(int corner)
{
  return meshToClip * vec4(texelFetch(points, texelFetch(cornerIds, corner).r).xyz, 1.0);
}

//VTK::ScreenPoint::Dec

void extend(vec2 pointVP, vec2 axis, inout Bounds b)
{
  vec2 along = vec2(dot(pointVP, axis), axis.x * pointVP.y - axis.y * pointVP.x);
  vec4 all = vec4(along, along.x + along.y, along.x - along.y);
  b.low = min(b.low, all);
  b.high = max(b.high, all);
}

// A line between two corners is cut once at most: all of them give the cell's cut, and more inside.
void extendToCuts(int first, int end, vec4 clip, vec2 axis, inout Bounds b)
{
  float before = clip.z + clip.w;
  for (int j = first; j < end; ++j)
  {
    vec4 other = clipOf(j);
    if (isBehindNearPlane(clip) != isBehindNearPlane(other))
    {
      float after = other.z + other.w;
      extend(pixelOf(mix(clip, other, before / (before - after))), axis, b);
    }
  }
}
