//VTK::System::Dec
//VTK::Output::Dec

// A face of a cell in one pixel. Pass 0: back faces add their depth to alpha, front faces subtract
// theirs, each as a share of the depth that the cell can have; pass 1: the emission times half that
// depth, to be multiplied by alpha; pass 2: alpha is taken back.

flat in int triangleVSOutput;

uniform isamplerBuffer cellHeaders;
uniform samplerBuffer cellPlanes; // of a cell: first its centre and radius
uniform samplerBuffer cellValues;
uniform int onePerCell;
uniform vec4 meshToDepth;
uniform int isMirrored;

//VTK::PassTriangle::Dec
//VTK::RayWeights::Dec
//VTK::Ray::Dec
//VTK::TransferFunction::Dec

vec4 emissionAt(float scalar)
{
  vec4 value = valueInInterval(firstInterval(scalar, false), scalar);
  return vec4(value.a * value.rgb, 0.0);
}

void main()
{
  ivec4 triangle = texelFetch(passTriangles, triangleVSOutput);
  vec4 sphere = texelFetch(cellPlanes, texelFetch(cellHeaders, triangle.y).x);
  float center = dot(meshToDepth.xyz, sphere.xyz) + meshToDepth.w;
  float halfDepth = sphere.w * length(meshToDepth.xyz);
  Ray ray = rayOfFragment();
  vec3 place = ray.point - sphere.xyz + center * ray.direction;
  mat3 corners;
  vec3 depths, scalars;
  for (int i = 0; i < 3; ++i)
  {
    vec4 corner = cornerOf(triangle, i);
    corners[i] = corner.xyz - sphere.xyz - place;
    depths[i] = dot(meshToDepth.xyz, corner.xyz - sphere.xyz);
    scalars[i] = onePerCell != 0 ? texelFetch(cellValues, triangle.y).r : corner.w;
  }
  vec3 weights = rayWeights(corners, ray.direction);
  int pass = triangle.z % 4;
  if (pass == 1)
  {
    gl_FragData[0] = emissionAt(dot(weights, scalars)) * halfDepth * ray.depthToLength;
    return;
  }
  float depth = dot(weights, depths);
  vec2 limits = ray.limits - center;
  float alpha = 0.5 + 0.5 * clamp(depth, limits.x, max(limits.x, limits.y)) / halfDepth;
  bool isFront = gl_FrontFacing != (isMirrored != 0);
  gl_FragData[0] = vec4(0.0, 0.0, 0.0, isFront == (pass == 0) ? -alpha : alpha);
}
