//VTK::System::Dec
//VTK::Output::Dec

// The scalar where a ray meets one piece of a face: the greater, or less, one where it meets both
// of the piece's triangles.

flat in int piece;

uniform isamplerBuffer pieceCorners;
uniform samplerBuffer points;
uniform samplerBuffer pieceScalars;
uniform int findLeast;

//VTK::Ray::Dec
//VTK::Triangle::Dec

void main()
{
  Ray ray = rayOfFragment();
  ivec4 ids = texelFetch(pieceCorners, piece);
  vec4 scalars = texelFetch(pieceScalars, piece);
  vec3 first = texelFetch(points, ids[0]).xyz;
  float square = dot(ray.direction, ray.direction);
  float depth = dot(first - ray.point, ray.direction) / square;
  // Everything counts from the ray's place beside the first corner, where floats are finest.
  vec3 place = (ray.point - first) + depth * ray.direction;
  vec3 corners[4];
  for (int i = 0; i < 4; ++i)
  {
    corners[i] = (texelFetch(points, ids[i]).xyz - first) - place;
  }
  bool found = false;
  float extremum = 0.0;
  for (int i = 1; i < (ids[2] == ids[3] ? 2 : 3); ++i)
  {
    vec2 hit; // depth and scalar
    if (meetsTriangle(corners[0], corners[i], corners[i + 1], ray.direction,
          vec3(scalars[0], scalars[i], scalars[i + 1]), hit) &&
        depth + hit.x >= ray.limits.x && depth + hit.x <= ray.limits.y)
    {
      bool better = !found || (findLeast != 0 ? hit.y < extremum : hit.y > extremum);
      extremum = better ? hit.y : extremum;
      found = true;
    }
  }
  if (!found)
  {
    discard;
  }
  gl_FragData[0] = vec4(extremum);
}
