#include "OracleIntegrator.h"

#include <algorithm>
#include <cmath>

namespace
{
const double Tolerance = 1e-11;
// 2^-60 of a piece is below the last place of its scalars: a step is then found as well as it can
// be.
const int LastLevel = 60;
}

//------------------------------------------------------------------------------
OracleIntegrator::Rgba OracleIntegrator::Composite(
  const std::vector<OracleSegment>& segments, const OracleRay& ray) const
{
  const Light light = this->Integrate(segments, ray, true);
  return { light.Color[0], light.Color[1], light.Color[2], -std::expm1(-light.Depth) };
}

//------------------------------------------------------------------------------
OracleIntegrator::Rgba OracleIntegrator::Add(
  const std::vector<OracleSegment>& segments, const OracleRay& ray) const
{
  const Light light = this->Integrate(segments, ray, false);
  return { light.Color[0], light.Color[1], light.Color[2], 0.0 };
}

//------------------------------------------------------------------------------
OracleIntegrator::Rgba OracleIntegrator::Maximum(const std::vector<OracleSegment>& segments) const
{
  if (segments.empty())
  {
    return { 0.0, 0.0, 0.0, 0.0 };
  }
  double extremum = segments.front().EntryScalar;
  for (const OracleSegment& segment : segments)
  {
    extremum = std::max({ extremum, segment.EntryScalar, segment.ExitScalar });
  }
  return this->Project(extremum);
}

//------------------------------------------------------------------------------
OracleIntegrator::Rgba OracleIntegrator::Minimum(const std::vector<OracleSegment>& segments) const
{
  if (segments.empty())
  {
    return { 0.0, 0.0, 0.0, 0.0 };
  }
  double extremum = segments.front().EntryScalar;
  for (const OracleSegment& segment : segments)
  {
    extremum = std::min({ extremum, segment.EntryScalar, segment.ExitScalar });
  }
  return this->Project(extremum);
}

//------------------------------------------------------------------------------
OracleIntegrator::Rgba OracleIntegrator::Project(double scalar) const
{
  const std::array<double, 3> color = this->Functions.GetColor(scalar);
  const double opacity = std::min(this->Functions.GetOpacity(scalar), 1.0);
  return { color[0] * opacity, color[1] * opacity, color[2] * opacity, opacity };
}

//------------------------------------------------------------------------------
OracleIntegrator::Light OracleIntegrator::Integrate(
  const std::vector<OracleSegment>& segments, const OracleRay& ray, bool absorbs) const
{
  Light sum;
  for (const OracleSegment& segment : segments)
  {
    for (const Piece& piece : this->Split(segment, ray))
    {
      const double transmittance = absorbs ? std::exp(-sum.Depth) : 1.0;
      const Light whole = this->Estimate(piece, absorbs);
      sum = Join(sum, this->Refine(piece, whole, transmittance, absorbs, 0), absorbs);
    }
  }
  return sum;
}

//------------------------------------------------------------------------------
OracleIntegrator::Piece OracleIntegrator::Piece::GetPart(double from, double to) const
{
  Piece part = *this;
  part.Entry = this->Entry + from * (this->Exit - this->Entry);
  part.Exit = this->Entry + to * (this->Exit - this->Entry);
  part.First = this->First + from * (this->Last - this->First);
  part.Last = this->First + to * (this->Last - this->First);
  part.Length = this->Length * (to - from);
  return part;
}

//------------------------------------------------------------------------------
std::vector<OracleIntegrator::Piece> OracleIntegrator::Split(
  const OracleSegment& segment, const OracleRay& ray) const
{
  const Piece whole = { segment.EntryScalar, segment.ExitScalar, segment.Exit - segment.Entry, 0.0,
    1.0, &segment, &ray };
  std::vector<double> shares = this->FindBreaks(segment.EntryScalar, segment.ExitScalar);
  if (this->Colors == OracleColors::OfOwnScalar)
  {
    for (double share : this->FindBreaks(segment.EntryColor.X, segment.ExitColor.X))
    {
      shares.push_back(share);
    }
    std::sort(shares.begin(), shares.end());
  }
  std::vector<Piece> pieces;
  for (std::size_t i = 1; i < shares.size(); ++i)
  {
    if (shares[i - 1] < shares[i])
    {
      pieces.push_back(whole.GetPart(shares[i - 1], shares[i]));
    }
  }
  return pieces;
}

//------------------------------------------------------------------------------
std::vector<double> OracleIntegrator::FindBreaks(double first, double last) const
{
  std::vector<double> shares = { 0.0 };
  for (double scalar : this->Functions.GetBreaks())
  {
    if (std::min(first, last) < scalar && scalar < std::max(first, last))
    {
      shares.push_back((scalar - first) / (last - first));
    }
  }
  shares.push_back(1.0);
  std::sort(shares.begin(), shares.end());
  return shares;
}

//------------------------------------------------------------------------------
OracleIntegrator::Light OracleIntegrator::Refine(
  const Piece& piece, const Light& whole, double transmittance, bool absorbs, int level) const
{
  const Piece frontPiece = piece.GetFront(), backPiece = piece.GetBack();
  Light front = this->Estimate(frontPiece, absorbs);
  Light back = this->Estimate(backPiece, absorbs);
  const Light joined = Join(front, back, absorbs);
  if (level == LastLevel || Agree(whole, joined, transmittance, absorbs))
  {
    return joined;
  }
  front = this->Refine(frontPiece, front, transmittance, absorbs, level + 1);
  const double behind = absorbs ? transmittance * std::exp(-front.Depth) : 1.0;
  back = this->Refine(backPiece, back, behind, absorbs, level + 1);
  return Join(front, back, absorbs);
}

//------------------------------------------------------------------------------
OracleIntegrator::Light OracleIntegrator::Estimate(const Piece& piece, bool absorbs) const
{
  using Values = OracleQuadrature::Values;
  Values depth;
  std::array<Values, 3> emission;
  const OracleSegment& segment = *piece.Segment;
  const bool hasGradientOpacity = this->Functions.HasGradientOpacity();
  for (int i = 0; i < OracleQuadrature::Size; ++i)
  {
    const double x = this->Quadrature.GetNodes()[i];
    const double scalar = piece.Entry + x * (piece.Exit - piece.Entry);
    const double share = piece.First + x * (piece.Last - piece.First);
    const OracleFunctions::Values values = this->Functions.GetValues(scalar);
    const std::array<double, 3> color = this->Shade(piece, share, values);
    depth[i] = this->Functions.GetExtinction(values) * piece.Length;
    if (hasGradientOpacity)
    {
      depth[i] *= this->Functions.GetGradientOpacity(segment.GetGradient(share).Length());
    }
    for (int channel = 0; channel < 3; ++channel)
    {
      emission[channel][i] = color[channel] * depth[i];
    }
  }
  Light light;
  light.Depth = this->Quadrature.Integrate(depth);
  const Values before = absorbs ? this->Quadrature.IntegrateToNodes(depth) : Values{};
  for (int i = 0; absorbs && i < OracleQuadrature::Size; ++i)
  {
    const double transmittance = std::exp(-before[i]);
    for (Values& channel : emission)
    {
      channel[i] *= transmittance;
    }
  }
  for (int channel = 0; channel < 3; ++channel)
  {
    light.Color[channel] = this->Quadrature.Integrate(emission[channel]);
  }
  return light;
}

//------------------------------------------------------------------------------
std::array<double, 3> OracleIntegrator::Shade(
  const Piece& piece, double share, const OracleFunctions::Values& values) const
{
  const std::array<double, 3> color = this->GetColor(piece, share, values);
  if (!this->Shading)
  {
    return color;
  }
  const OracleSegment& segment = *piece.Segment;
  const double t = segment.Entry + share * (segment.Exit - segment.Entry);
  return this->Shading->Shade(color, segment.GetGradient(share), piece.Ray->GetPoint(t),
    piece.Ray->Direction * -1.0);
}

//------------------------------------------------------------------------------
std::array<double, 3> OracleIntegrator::GetColor(
  const Piece& piece, double share, const OracleFunctions::Values& values) const
{
  if (this->Colors == OracleColors::OfScalar)
  {
    return { values[0], values[1], values[2] };
  }
  const OracleVector own = piece.Segment->GetColor(share);
  return this->Colors == OracleColors::OfOwnScalar
    ? this->Functions.GetColor(own.X)
    : std::array<double, 3>{ own.X, own.Y, own.Z };
}

//------------------------------------------------------------------------------
OracleIntegrator::Light OracleIntegrator::Join(const Light& front, const Light& back, bool absorbs)
{
  const double transmittance = absorbs ? std::exp(-front.Depth) : 1.0;
  Light both;
  both.Depth = front.Depth + back.Depth;
  for (int channel = 0; channel < 3; ++channel)
  {
    both.Color[channel] = front.Color[channel] + transmittance * back.Color[channel];
  }
  return both;
}

//------------------------------------------------------------------------------
bool OracleIntegrator::Agree(const Light& a, const Light& b, double transmittance, bool absorbs)
{
  // Written so that what is not a number agrees: halving it would never end.
  const double alphas = std::abs(std::exp(-a.Depth) - std::exp(-b.Depth));
  bool agree = !absorbs || !(transmittance * alphas > Tolerance);
  for (int channel = 0; channel < 3; ++channel)
  {
    const double difference = std::abs(a.Color[channel] - b.Color[channel]);
    const double bound = Tolerance * std::max(1.0, std::abs(b.Color[channel]));
    agree = agree && !(transmittance * difference > bound);
  }
  return agree;
}
