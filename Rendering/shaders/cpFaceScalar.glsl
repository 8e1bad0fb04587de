// The scalar where a ray meets a face: linear on each triangle of it (class FacePieces).

uniform samplerBuffer pieceShapes;  // 3 texels a piece
uniform samplerBuffer pieceScalars; // of the four corners
uniform samplerBuffer cellValues;
uniform int onePerCell;

vec3 firstPoint(int piece)
{
  return texelFetch(pieceShapes, 3 * piece + 2).xyz;
}

// `point` in mesh coordinates relative to `center`.
float scalarOnFace(int piece, vec3 center, vec3 point)
{
  vec4 first = texelFetch(pieceShapes, 3 * piece + 2);
  vec3 offset = point + (center - first.xyz);
  vec4 shapeU = texelFetch(pieceShapes, 3 * piece);
  vec4 shapeW = texelFetch(pieceShapes, 3 * piece + 1);
  float u = dot(shapeU.xyz, offset);
  float w = dot(shapeW.xyz, offset);
  // Above zero: the face goes on beyond the edge of v0 and v3.
  while (shapeW.w > 0.0 && w > 0.0 && u < shapeU.w * w)
  {
    ++piece;
    first = texelFetch(pieceShapes, 3 * piece + 2);
    shapeU = texelFetch(pieceShapes, 3 * piece);
    shapeW = texelFetch(pieceShapes, 3 * piece + 1);
    u = dot(shapeU.xyz, offset);
    w = dot(shapeW.xyz, offset);
  }
  vec4 scalars = texelFetch(pieceScalars, piece);
  // Clamped: rounding must not leave the range of the corners' scalars.
  float side = clamp(w > 0.0 ? w : -w / abs(shapeW.w), 0.0, 1.0);
  float end = clamp(u - (w > 0.0 ? shapeU.w : first.w) * side, 0.0, 1.0 - side);
  return (1.0 - side - end) * scalars.x + end * scalars.z + side * (w > 0.0 ? scalars.w : scalars.y);
}
