// The triangles of three passes (class PassTriangles) and their corners.

uniform isamplerBuffer passTriangles; // piece, cell, pass + 4 (second half) + 8 turned; piece < 0: explicit
uniform samplerBuffer cutVertices;    // point and scalar, three per explicit triangle
uniform isamplerBuffer pieceCorners;
uniform samplerBuffer pieceScalars;
uniform samplerBuffer points;

// Point and scalar.
vec4 cornerOf(ivec4 triangle, int corner)
{
  if (triangle.x < 0)
  {
    return texelFetch(cutVertices, 3 * (-1 - triangle.x) + corner);
  }
  int second = (triangle.z / 4) % 2;
  bool turned = triangle.z >= 8;
  int at = corner == 0 ? 0 : second + (turned ? 3 - corner : corner);
  int id = texelFetch(pieceCorners, triangle.x)[at];
  return vec4(texelFetch(points, id).xyz, texelFetch(pieceScalars, triangle.x)[at]);
}
