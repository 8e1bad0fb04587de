#ifndef CoarseImage_h
#define CoarseImage_h

#include <array>
#include <vector>

/**
 * @class CoarseImage
 * @brief An image with fewer pixels than its viewport: the opaque depths that its rays end at, and
 * the image of the viewport's size that is made of it.
 *
 * A pixel of the viewport lies between four of the coarse ones. They count by their distance in the
 * viewport and, where there is opaque geometry, by how near their opaque depth is to the pixel's own:
 * what is before a surface does not leak beside it.
 */
class CoarseImage
{
public:
  /// Takes the viewport's size and the distance of the coarse pixels, 1 or more.
  void SetSize(int width, int height, double distance);

  int GetWidth() const { return this->Coarse[0]; }
  int GetHeight() const { return this->Coarse[1]; }

  /// Window depths of the viewport, row by row, to those of the coarse pixels' own rays: of the
  /// pixel in which each one lies. Both empty where nothing opaque is there.
  const std::vector<float>& ReduceDepths(std::vector<float>& depths);

  /// RGBA of the viewport's size, from that of the coarse size. The image stays until the next call.
  const float* Enlarge(const float* image);

private:
  /// Where a pixel of the viewport lies between two coarse ones.
  struct Place
  {
    int First, Second;
    float Share; // of the second
  };
  static std::vector<Place> FindPlaces(int size, int coarse);
  /// Weights of the four coarse pixels around one of the viewport.
  std::array<float, 4> Weigh(const Place& x, const Place& y, const float* depth) const;
  void EnlargeRow(const float* image, int y);

  int Size[2] = { 1, 1 };
  int Coarse[2] = { 1, 1 };
  std::vector<float> Depths, CoarseDepths;
  std::vector<Place> Columns, Rows;
  std::vector<float> Image;
};

#endif
