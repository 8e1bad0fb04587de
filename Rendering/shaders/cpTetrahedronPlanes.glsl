// The planes of a tetrahedron's faces. Corners come in ascending order of their ids, so that two
// cells compute the plane of their shared face from the same numbers in the same order.

struct Planes
{
  vec3 normal[4];     // of the face opposite each corner: the same in the neighbour
  vec4 inverseHeight; // of each corner over that face; below zero where the normal points away
};

Planes planesOf(vec3 p[4])
{
  Planes planes;
  planes.normal[0] = cross(p[2] - p[1], p[3] - p[1]);
  planes.normal[1] = cross(p[2] - p[0], p[3] - p[0]);
  planes.normal[2] = cross(p[1] - p[0], p[3] - p[0]);
  planes.normal[3] = cross(p[1] - p[0], p[2] - p[0]);
  for (int i = 0; i < 4; ++i)
  {
    float height = dot(planes.normal[i], p[i] - (i == 0 ? p[1] : p[0]));
    planes.inverseHeight[i] = height != 0.0 ? 1.0 / height : 0.0;
  }
  return planes;
}
