// Where a ray meets a triangle that the rasteriser found in its pixel, as weights of the corners.
// The rasteriser moves corners to a grid (GL_SUBPIXEL_BITS) and a GPU interpolates between those: a
// steep triangle's depth is then wrong by its slope. Beside the triangle, by as much as corners move,
// its plane goes on; where that is far for so narrow a triangle, the ray counts as that through the
// nearest point of the rim.

const float beside = 0.01;
const float edgeOn = 4e-7;

vec3 acrossRay(vec3 offset, vec3 direction)
{
  return offset - dot(offset, direction) / dot(direction, direction) * direction;
}

vec3 weightsOnRim(mat3 corners, vec3 direction)
{
  vec3 weights = vec3(0.0);
  float nearest = 1e30;
  for (int i = 0; i < 3; ++i)
  {
    int next = (i + 1) % 3;
    vec3 first = acrossRay(corners[i], direction);
    vec3 edge = acrossRay(corners[next], direction) - first;
    float share = clamp(-dot(first, edge) / max(dot(edge, edge), 1e-30), 0.0, 1.0);
    vec3 miss = first + share * edge;
    if (dot(miss, miss) < nearest)
    {
      nearest = dot(miss, miss);
      weights = vec3(0.0);
      weights[i] = 1.0 - share;
      weights[next] = share;
    }
  }
  return weights;
}

// `corners` relative to a point of the ray.
vec3 rayWeights(mat3 corners, vec3 direction)
{
  vec3 a = corners[0];
  vec3 b = corners[1];
  vec3 c = corners[2];
  // Areas as seen along the ray, each of a corner's far edge and the ray.
  vec3 areas = vec3(dot(direction, cross(b, c)), dot(direction, cross(c, a)),
    dot(direction, cross(a, b)));
  float sum = areas.x + areas.y + areas.z;
  float longest = sqrt(max(dot(c - b, c - b), max(dot(a - c, a - c), dot(b - a, b - a))));
  float least = min(areas.x * sign(sum), min(areas.y * sign(sum), areas.z * sign(sum)));
  bool isWithin = least >= -beside * abs(sum) && abs(sum) > edgeOn * longest * length(direction);
  return isWithin ? areas / sum : weightsOnRim(corners, direction);
}
