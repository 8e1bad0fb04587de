// Faces of five and more corners are several pieces: the one that holds a point.

int pieceAround(int piece, vec3 center, vec3 point)
{
  vec4 first = texelFetch(pieceShapes, 3 * piece + 2);
  vec3 offset = point + (center - first.xyz);
  vec4 shapeU = texelFetch(pieceShapes, 3 * piece);
  vec4 shapeW = texelFetch(pieceShapes, 3 * piece + 1);
  // Above zero: the face goes on beyond the edge of v0 and v3.
  while (shapeW.w > 0.0 && dot(shapeW.xyz, offset) > 0.0 &&
    dot(shapeU.xyz, offset) < shapeU.w * dot(shapeW.xyz, offset))
  {
    ++piece;
    shapeU = texelFetch(pieceShapes, 3 * piece);
    shapeW = texelFetch(pieceShapes, 3 * piece + 1);
  }
  return piece;
}
