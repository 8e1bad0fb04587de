//VTK::System::Dec

// A vertex of an iso-surface (class IsoTriangles), mesh coordinates, and the plane of the triangle
// whose last vertex it is (class NumberedTriangles): the fragments of that one take it from here.
// Where a fragment's ray, `step` pixels from rayPixel, meets the plane, its depth is
// (planeAbove . (1, step)) / (planeRise . (1, step)); w: the triangle's least and greatest depth.

uniform samplerBuffer trianglePoints;   // w 0: not finite
uniform isamplerBuffer triangleCorners; // of each vertex: three points, the last its own
uniform mat4 meshToClip;
uniform vec4 meshToDepth; // depth of a point in mesh coordinates
uniform vec3 rayPoint[3]; // as in cpRay.glsl
uniform vec3 rayDirection[3];

flat out vec4 planeAbove;
flat out vec4 planeRise;
//VTK::Gradient::Dec

void main()
{
  ivec4 ids = texelFetch(triangleCorners, gl_VertexID);
  vec4 a = texelFetch(trianglePoints, ids.x);
  vec4 b = texelFetch(trianglePoints, ids.y);
  vec4 c = texelFetch(trianglePoints, ids.z);
  vec3 normal = cross(a.xyz - c.xyz, b.xyz - c.xyz);
  planeAbove.x = dot(normal, c.xyz - rayPoint[0]);
  planeAbove.yz = -vec2(dot(normal, rayPoint[1]), dot(normal, rayPoint[2]));
  for (int i = 0; i < 3; ++i)
  {
    planeRise[i] = dot(normal, rayDirection[i]);
  }
  vec3 depths = meshToDepth.xyz * mat3(a.xyz, b.xyz, c.xyz) + meshToDepth.w;
  planeAbove.w = min(min(depths.x, depths.y), depths.z);
  // Of a triangle that is not finite before all that can be seen.
  planeRise.w = min(min(a.w, b.w), c.w) > 0.0 ? max(max(depths.x, depths.y), depths.z) : -1e30;
  //VTK::Gradient::Impl
  gl_Position = meshToClip * vec4(c.xyz, 1.0);
}
