/**
 * Light in two places along thin fragments: grey and directional (class ThinLight).
 */
#if defined(TileThinShine_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TileThinShine_inl_h
#undef TileThinShine_inl_h
#else
#define TileThinShine_inl_h
#endif

#include "TileLighting.h"
#include "TileMath-inl.h"
#include "TilePieces-inl.h"
#include "TileThinCourses-inl.h"

#include <hwy/highway.h>

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

/// Sums over the lights at the two places.
struct ThinShine
{
  ShadeVector Factor[2], Highlight[2];
  ShadeMask StaysBefore; // no light is passed from one side to the other
};

/// To a power that is whole and at least 2.
HWY_INLINE void Raise(int power, ShadeVector (&bases)[2])
{
  int left = power;
  for (; (left & 1) == 0; left >>= 1)
  {
    bases[0] = hn::Mul(bases[0], bases[0]);
    bases[1] = hn::Mul(bases[1], bases[1]);
  }
  ShadeVector powers[2] = { bases[0], bases[1] };
  while ((left >>= 1) != 0)
  {
    powers[0] = hn::Mul(powers[0], powers[0]);
    powers[1] = hn::Mul(powers[1], powers[1]);
    if (left & 1)
    {
      bases[0] = hn::Mul(bases[0], powers[0]);
      bases[1] = hn::Mul(bases[1], powers[1]);
    }
  }
}

/// What all lights need of the gradients: roots are taken twice as great, see TwiceInverseRoot.
struct ThinSights
{
  ShadeVector Inverse[2], Seen[2];
  ShadeVector PerEye, Depth;

  HWY_INLINE ThinSights(const ThinCourse& c, const ThinGradients& g, ShadeVector scale)
    : PerEye(hn::Mul(c.PerEye, scale))
    , Depth(c.Depth)
  {
    for (int i = 0; i < 2; ++i)
    {
      this->Inverse[i] = TwiceInverseRoot(ShadeFloat(), g.Square[i]);
      const auto toEye = hn::MulAdd(c.EyeX, g.At[i][0], hn::MulAdd(c.EyeY, g.At[i][1], g.At[i][2]));
      this->Seen[i] = hn::Mul(toEye, this->Inverse[i]);
    }
  }

  /// Whether both ends are on the same side, or what turns away is too little to be seen.
  HWY_INLINE ShadeMask StayBefore(const ShadeVector (&cosine)[2]) const
  {
    const ShadeFloat d;
    const auto apart = hn::Abs(hn::Sub(cosine[0], cosine[1]));
    const auto turned = hn::Mul(apart, hn::Set(d, 1.73205081f));
    const auto beyond = hn::Sub(turned, hn::Abs(hn::Add(cosine[0], cosine[1])));
    const auto seen = hn::MulSub(turned, this->Depth, hn::Set(d, 2.0f * LeastKink));
    return hn::Le(hn::Min(beyond, seen), hn::Zero(d));
  }

  /// Bases of highlights.
  HWY_INLINE void Mirror(const ShadeVector (&cosine)[2], ShadeVector toLight, ShadeVector (&mirrored)[2]) const
  {
    const ShadeFloat d;
    for (int i = 0; i < 2; ++i)
    {
      const auto above = hn::Max(hn::MulSub(cosine[i], this->Seen[i], toLight), hn::Zero(d));
      mirrored[i] = hn::Mul(above, this->PerEye);
    }
  }
};

/// One light along the view, with a highlight.
class ThinHeadlight
{
public:
  explicit ThinHeadlight(const TileLighting& lighting)
    : Power(static_cast<int>(lighting.Power))
    , Ambient(Spread(0.5f * lighting.Ambient[0]))
    , Diffuse(Spread(0.25f * lighting.Lights[0].Diffuse[0]))
    , Scale(Spread(0.25f * std::pow(0.5f * lighting.Lights[0].Specular[0], 1.0f / lighting.Power)))
    , ToLight(Spread(2.0f * lighting.Lights[0].Towards[2]))
  {
  }

  static bool Suits(const TileLighting& lighting)
  {
    return lighting.Lights.size() == 1 && lighting.Lights[0].IsAlongView && lighting.Lights[0].Specular[0] > 0.0f;
  }

  HWY_INLINE void Shine(const ThinCourse& c, const ThinGradients& g, ThinShine& shine) const
  {
    const ThinSights sights(c, g, this->Scale);
    const ShadeVector cosine[2] = { hn::Mul(g.At[0][2], sights.Inverse[0]),
      hn::Mul(g.At[1][2], sights.Inverse[1]) };
    shine.StaysBefore = sights.StayBefore(cosine);
    sights.Mirror(cosine, this->ToLight, shine.Highlight);
    Raise(this->Power, shine.Highlight);
    for (int i = 0; i < 2; ++i)
    {
      shine.Factor[i] = hn::MulAdd(hn::Abs(cosine[i]), this->Diffuse, this->Ambient);
    }
  }

private:
  static ShadeVector Spread(float value) { return hn::Set(ShadeFloat(), value); }

  const int Power;
  // Scale: of bases, whose powers have the light's strength then.
  const ShadeVector Ambient, Diffuse, Scale, ToLight;
};

/// Any lights.
class ThinLights
{
public:
  explicit ThinLights(const TileLighting& lighting)
    : Lighting(lighting)
    , Power(static_cast<int>(lighting.Power))
  {
  }

  HWY_INLINE void Shine(const ThinCourse& c, const ThinGradients& g, ThinShine& shine) const
  {
    const ShadeFloat d;
    const ThinSights sights(c, g, hn::Set(d, 0.25f));
    for (int i = 0; i < 2; ++i)
    {
      shine.Factor[i] = hn::Set(d, 0.5f * this->Lighting.Ambient[0]);
      shine.Highlight[i] = hn::Zero(d);
    }
    shine.StaysBefore = c.Fits;
    for (const TileLight& light : this->Lighting.Lights)
    {
      const auto diffuse = hn::Set(d, 0.25f * light.Diffuse[0]);
      ShadeVector cosine[2];
      for (int i = 0; i < 2; ++i)
      {
        cosine[i] = hn::Mul(Dot(g.At[i], light.Towards), sights.Inverse[i]);
        shine.Factor[i] = hn::MulAdd(hn::Abs(cosine[i]), diffuse, shine.Factor[i]);
      }
      shine.StaysBefore = hn::And(shine.StaysBefore, sights.StayBefore(cosine));
      if (this->Lighting.HasHighlight)
      {
        this->AddHighlight(c, light, cosine, sights, shine);
      }
    }
  }

private:
  HWY_INLINE void AddHighlight(const ThinCourse& c, const TileLight& light,
    const ShadeVector (&cosine)[2], const ThinSights& sights, ThinShine& shine) const
  {
    const ShadeFloat d;
    auto toLight = hn::Set(d, 2.0f * light.Towards[2]);
    toLight = hn::MulAdd(c.EyeX, hn::Set(d, 2.0f * light.Towards[0]), toLight);
    toLight = hn::MulAdd(c.EyeY, hn::Set(d, 2.0f * light.Towards[1]), toLight);
    ShadeVector mirrored[2];
    sights.Mirror(cosine, toLight, mirrored);
    Raise(this->Power, mirrored);
    const auto specular = hn::Set(d, 0.5f * light.Specular[0]);
    for (int i = 0; i < 2; ++i)
    {
      shine.Highlight[i] = hn::MulAdd(mirrored[i], specular, shine.Highlight[i]);
    }
  }

  const TileLighting& Lighting;
  const int Power;
};

}
}
HWY_AFTER_NAMESPACE();

#endif
