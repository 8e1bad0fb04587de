#include "OracleLight.h"

//------------------------------------------------------------------------------
OracleVector OracleLight::GetDirectionFrom(const OracleVector& point) const
{
  const OracleVector way = this->IsPositional ? this->Position - point : this->Direction * -1.0;
  const double length = way.Length();
  return length > 0.0 ? way * (1.0 / length) : OracleVector();
}

//------------------------------------------------------------------------------
double OracleLight::GetShareAt(const OracleVector& point) const
{
  if (!this->IsPositional)
  {
    return 1.0;
  }
  const double distance = (this->Position - point).Length();
  const std::array<double, 3>& a = this->Attenuation;
  const double weakened = 1.0 / (a[0] + a[1] * distance + a[2] * distance * distance);
  if (!this->IsSpot)
  {
    return weakened;
  }
  const double cosine = -this->GetDirectionFrom(point).Dot(this->Direction);
  return cosine >= this->ConeCosine ? weakened * std::pow(cosine, this->Exponent) : 0.0;
}
