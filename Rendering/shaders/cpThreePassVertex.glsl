//VTK::System::Dec

// A corner of a triangle of a cell's surface, in one of the three passes over that cell.
// Output: the triangle, for fragments to fetch.

uniform mat4 meshToClip;

flat out int triangleVSOutput;

//VTK::PassTriangle::Dec

void main()
{
  triangleVSOutput = gl_VertexID / 3;
  vec4 corner = cornerOf(texelFetch(passTriangles, triangleVSOutput), gl_VertexID % 3);
  gl_Position = meshToClip * vec4(corner.xyz, 1.0);
}
