/**
 * What light, gradient opacity and other components than the opacity's make of fragments, as the
 * tiles read it. In mesh coordinates where those differ from the view's by a rotation and one scale
 * alone and class ThinLight is of no use, else in view coordinates.
 *
 *     colour (Ambient + sum(arriving Diffuse |n.l|)) + sum(arriving Specular (r.v)^Power)
 *
 * with n the normalised gradient, l towards the light and r its mirror image; where the gradient is
 * zero, Ambient alone. The coefficients of the material are in the colours of the lights.
 */
#ifndef TileLighting_h
#define TileLighting_h

#include "TileTransfer.h"
#include "TileView.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <vector>

class VolumeShading;
struct SceneLight;

/** One light: towards it, or its position; of a positional one also the cone and how it fades. */
struct TileLight
{
  bool IsPositional = false;
  bool HasCone = false;
  glm::vec3 Place{ 0.0f };
  /** The way to a directional light in view coordinates; whether it is (0, 0, 1). */
  glm::vec3 Towards{ 0.0f };
  bool IsAlongView = false;
  glm::vec3 Axis{ 0.0f };
  float ConeCosine = -2.0f;
  float Exponent = 0.0f;
  glm::vec3 Attenuation{ 1.0f, 0.0f, 0.0f };
  /** A directional light's ambient part is in TileLighting::Ambient. */
  glm::vec3 Ambient{ 0.0f };
  glm::vec3 Diffuse{ 0.0f };
  glm::vec3 Specular{ 0.0f };
};

class TileLighting
{
public:
  /** As many as Raster draws. */
  static constexpr int MaximumLights = 16;

  void Build(const VolumeShading& shading, const TileView& view, const TileView::Camera& camera);

  bool IsLit = false;
  std::vector<TileLight> Lights;
  glm::vec3 Ambient{ 0.0f };
  float Power = 1.0f;
  /** Whether ambient, diffuse and specular light have equal channels. */
  bool IsGrey = true;
  /** Whether a light has a highlight, and one that begins with an edge. */
  bool HasHighlight = false, HasGlance = false;
  /** The tangent of the angle that the gradient may turn by in one piece of an optical depth of 1. */
  float GreatestTurn = 1.0f;

  bool HasOpacity = false;
  /** Of the length of the gradient times GradientScale; the opacity takes extinction's place. */
  TileTransfer Opacity;
  float GradientScale = 1.0f;
  /** Whether gradients are turned to the view, and how. */
  bool IsInView = false;
  /** Whether lengths in the world are those in the mesh times a number. */
  bool HasOneScale = false;
  glm::mat3 GradientToView{ 1.0f };

  enum ColorKinds
  {
    OwnColor,
    ScalarColor,
    DirectColor
  };
  ColorKinds ColorKind = OwnColor;
  TileTransfer ColorFunction;

  /** Points of a ray times weight(u) are columns 0 x + 1 y + 2 u + 3. */
  glm::dmat4 ScreenToMesh{ 1.0 }, ScreenToLights{ 1.0 };

  /** In view coordinates the way of a ray to the eye is (x, y, 1), up to a factor. */
  struct ViewRays
  {
    /** x and y at pixel 0, 0; what they change by per pixel. */
    double ToEye[2] = { 0.0, 0.0 }, PerPixel[2] = { 0.0, 0.0 };
    /** World length of a piece of a ray over that of (x, y, 1) and the difference of 1 / weight. */
    double LengthPerWay = 0.0;
  };
  ViewRays Rays;
  /** Whether all is as class ThinLight has it: grey directional light, no opacity or colours of
   *  others than the scalar, rays as ViewRays. */
  bool AllowsThin = false;

private:
  // Of all lights together.
  float Specular = 0.0f;

  void AddLight(const SceneLight& light, const VolumeShading& shading);
  bool SetRays(const TileView& view, const TileView::Camera& camera);
  bool HasThinLights() const;
  void SetGreatestTurn();
  void SetSpace(const VolumeShading& shading, const TileView::Camera& camera);
  bool HasGreyLights() const;
  void MoveLights(const glm::dmat4& viewToMesh, float scale);
};

#endif
