#ifndef ViewRays_h
#define ViewRays_h

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/**
 * @class ViewRays
 * @brief The ray through every pixel, in mesh coordinates.
 *
 * Mesh coordinates are data coordinates about the mesh's centre, divided by its size: huge (UTM)
 * and tiny coordinates keep their digits in a float, and products of three lengths stay in its
 * range.
 *
 * A ray is parametrised by its depth along the view axis, measured from Reference: the plane at
 * right angles to the view axis through the mesh's centre. Pixel coordinates are those of
 * gl_FragCoord within the viewport. All members are evaluated in double and rounded once, so that
 * every cell sees the same ray, and distances inside the mesh do not lose digits to a distant eye.
 *
 *     point(pixel) = Point[0] + (pixel - Pixel).x Point[1] + (pixel - Pixel).y Point[2]
 *
 * likewise the direction, and both in view coordinates. World is the direction in the world: the
 * world length of a piece is its depth times the length of that.
 */
class ViewRays
{
public:
  struct Transforms
  {
    glm::dmat4 DataToWorld{ 1.0 };
    glm::dmat4 WorldToView{ 1.0 };
    glm::dmat4 ViewToClip{ 1.0 };
    /// Data = Center + Scale * mesh coordinates.
    glm::dvec3 Center{ 0.0 };
    double Scale = 1.0;
    int Width = 1;
    int Height = 1;
  };

  /// False where a matrix cannot be inverted or has no near or far plane, as where one is 1e-16 of the other: nothing can be
  /// seen then.
  bool Build(const Transforms& transforms);

  glm::vec2 Pixel{ 0.0f };
  glm::vec3 Point[3];
  glm::vec3 Direction[3];
  glm::vec3 World[3];
  /// xy: point, zw: direction.
  glm::vec4 View[3];
  /// Depth of the reference plane, of the near and of the far plane from the eye.
  double Reference = 0.0, Near = 0.0, Far = 0.0;
  /// Window depth z to depth from the reference: (x + y z) / (z + w z).
  glm::vec4 DepthFromWindow{ 0.0f };
  glm::mat4 MeshToClip{ 1.0f };
  glm::dmat4 MeshToView{ 1.0 };
  glm::dmat4 MeshToWorld{ 1.0 };
  /// Where all rays meet, in mesh coordinates; w is 0 where they are parallel.
  glm::dvec4 Eye{ 0.0, 0.0, 0.0, 1.0 };
  /// Its depth from the reference plane; of parallel rays that of the view's origin.
  double EyeDepth = 0.0;
  /// Of the viewport, in pixels.
  glm::ivec2 Size{ 1, 1 };
  glm::dmat4 ViewToClip{ 1.0 };
  glm::dmat4 ViewToWorld{ 1.0 };

private:
  void SetDepths(const Transforms& transforms, const glm::dmat4& clipToView);
  void SetRays(const Transforms& transforms, const glm::dmat4& clipToView);
  void SetEye(const glm::dmat4& clipToView);
};

#endif
