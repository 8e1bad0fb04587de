// Where a ray is inside a convex cell: entry = largest depth of a front plane, exit = smallest depth
// of a back plane. Planes come from class CellPlanes.

uniform isamplerBuffer cellHeaders; // first texel, planes + 65536 pairs, first corner, corners
uniform samplerBuffer cellPlanes;   // of a cell: its centre, then inward normals and offsets
uniform isamplerBuffer planePieces; // of a plane: the first piece of its face

const vec3 nudge = vec3(0.6180340, 0.4142136, 0.2360680); // along no face of a tidy mesh
const float farAway = 1e30;

struct Passage
{
  vec3 center;
  vec3 place;  // the ray's place next to the centre, from there
  float depth; // of that place
  vec2 depths; // of entry and exit, from that place
  ivec2 planes; // through which it enters and leaves
};

//VTK::FaceScalar::Dec

// A ray along a face counts as moved a little, all rays to the same side: it sees one of the face's
// two cells. The face's own point decides, as it is the same for both.
bool isOutside(int plane, vec3 normal, vec3 point)
{
  float side = dot(normal, point - firstPoint(texelFetch(planePieces, plane).r));
  return (side != 0.0 ? side : dot(normal, nudge)) < 0.0;
}

void cutAtPlane(int plane, Ray ray, float parallel, inout Passage p)
{
  vec4 texel = texelFetch(cellPlanes, plane);
  float slope = dot(texel.xyz, ray.direction);
  float depth = -(dot(texel.xyz, p.place) + texel.w) / slope;
  if (abs(slope) <= parallel)
  {
    p.depths.y = isOutside(plane, texel.xyz, ray.point) ? -farAway : p.depths.y;
  }
  else if (slope > 0.0 && depth > p.depths.x)
  {
    p.depths.x = depth;
    p.planes.x = plane;
  }
  else if (slope < 0.0 && depth < p.depths.y)
  {
    p.depths.y = depth;
    p.planes.y = plane;
  }
}
//VTK::Valley::Dec
