#include "OracleShading.h"

//------------------------------------------------------------------------------
OracleShading::Color OracleShading::Shade(const Color& kappa, const OracleVector& gradient,
  const OracleVector& point, const OracleVector& toEye) const
{
  const double length = gradient.Length();
  const OracleVector normal = length > 0.0 ? gradient * (1.0 / length) : OracleVector();
  Color shaded = { 0.0, 0.0, 0.0 };
  for (const OracleLight& light : this->Lights)
  {
    const double share = light.GetShareAt(point);
    const OracleVector toLight = light.GetDirectionFrom(point);
    const double cosine = std::abs(normal.Dot(toLight));
    const bool shines = length > 0.0 && this->Specular != 0.0;
    const double highlight = shines ? this->GetHighlight(normal, toLight, toEye) : 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double arriving = share * light.Diffuse[i];
      shaded[i] += kappa[i] *
                     (this->Ambient * (light.Ambient[i] + arriving) +
                       this->Diffuse * arriving * cosine) +
                   this->Specular * share * light.Specular[i] * highlight;
    }
  }
  return shaded;
}

//------------------------------------------------------------------------------
double OracleShading::GetHighlight(
  const OracleVector& normal, const OracleVector& toLight, const OracleVector& toEye) const
{
  const OracleVector reflected = normal * (2.0 * normal.Dot(toLight)) - toLight;
  const double cosine = reflected.Dot(toEye);
  return cosine > 0.0 ? std::pow(cosine, this->Power) : 0.0;
}
