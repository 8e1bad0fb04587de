//VTK::System::Dec

// A vertex of an iso-surface (class IsoTriangles), mesh coordinates.

uniform samplerBuffer trianglePoints;
uniform samplerBuffer triangleGradients;
uniform mat4 meshToClip;

//VTK::Gradient::Dec

void main()
{
  //VTK::Gradient::Impl
  gl_Position = meshToClip * vec4(texelFetch(trianglePoints, gl_VertexID).xyz, 1.0);
}
