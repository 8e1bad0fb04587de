//VTK::System::Dec

// A corner of a triangle of a cell's surface, in one of the three passes over that cell.
// Input: gl_VertexID / 3 is the triangle. Output: depth from the cell's centre, scalar.

uniform isamplerBuffer passTriangles; // piece, cell, pass + 4 (second half) + 8 turned; piece < 0: explicit
uniform samplerBuffer cutVertices;    // point and scalar, three per explicit triangle
uniform isamplerBuffer pieceCorners;
uniform samplerBuffer pieceScalars;
uniform samplerBuffer points;
uniform isamplerBuffer cellHeaders;
uniform samplerBuffer cellPlanes; // of a cell: first its centre and radius
uniform samplerBuffer cellValues;
uniform int onePerCell;
uniform mat4 meshToClip;
uniform vec4 meshToDepth;

out float depthVSOutput;
out float scalarVSOutput;
flat out vec2 cellVSOutput; // depth of the centre; half of the depth that the cell can have
flat out int passVSOutput;

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

void main()
{
  ivec4 triangle = texelFetch(passTriangles, gl_VertexID / 3);
  vec4 corner = cornerOf(triangle, gl_VertexID % 3);
  vec4 sphere = texelFetch(cellPlanes, texelFetch(cellHeaders, triangle.y).x);
  depthVSOutput = dot(meshToDepth.xyz, corner.xyz - sphere.xyz);
  scalarVSOutput = onePerCell != 0 ? texelFetch(cellValues, triangle.y).r : corner.w;
  cellVSOutput.x = dot(meshToDepth.xyz, sphere.xyz) + meshToDepth.w;
  cellVSOutput.y = sphere.w * length(meshToDepth.xyz);
  passVSOutput = triangle.z % 4;
  gl_Position = meshToClip * vec4(corner.xyz, 1.0);
}
