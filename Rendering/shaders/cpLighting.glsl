// Phong's model, two-sided, for all lights of the scene (class SceneLighting), view coordinates.

const int maximumLights = 16;
// Five a light: to the light or its position, w 1 for a position; where it shines, w the cone's
// cosine; attenuation, w the exponent; diffuse colour; specular colour.
uniform vec4 lights[5 * maximumLights];
uniform int numberOfLights;
uniform vec3 ambientLight;
uniform vec4 material; // ambient, diffuse, specular, power

// The unit vector to a light, and how much of it arrives.
vec3 toLight(int light, vec3 point, out float arriving)
{
  vec4 place = lights[5 * light];
  vec4 axis = lights[5 * light + 1];
  vec4 fading = lights[5 * light + 2];
  vec3 way = place.xyz - place.w * point;
  float far = length(way);
  way /= max(far, 1e-30);
  arriving = 1.0;
  if (place.w > 0.0)
  {
    float cosine = -dot(way, axis.xyz);
    arriving = cosine >= axis.w ? pow(max(cosine, 1e-30), fading.w) : 0.0;
    arriving /= dot(fading.xyz, vec3(1.0, far, far * far));
  }
  return way;
}

struct Light
{
  vec3 ambient;
  vec3 diffuse;
  vec3 highlight;
};

// What arrives where `share` of the way is passed.
Light lightAt(float share)
{
  vec3 gradient = gradientAt(share);
  float size = length(gradient);
  vec3 normal = gradient / max(size, 1e-30);
  vec3 point = wayEntry + share * wayRise;
  Light sum = Light(material.x * ambientLight, vec3(0.0), vec3(0.0));
  for (int i = 0; i < numberOfLights; ++i)
  {
    float arriving;
    vec3 way = toLight(i, point, arriving);
    float cosine = dot(normal, way);
    sum.ambient += arriving * material.x * lights[5 * i + 3].rgb;
    sum.diffuse += arriving * material.y * abs(cosine) * lights[5 * i + 3].rgb;
    float mirrored = dot(2.0 * cosine * normal - way, toEye);
    float shine = size > 0.0 && mirrored > 0.0 ? pow(mirrored, material.w) : 0.0;
    sum.highlight += arriving * material.z * shine * lights[5 * i + 4].rgb;
  }
  return sum;
}
