#ifndef ImageSampling_h
#define ImageSampling_h

/**
 * @class ImageSampling
 * @brief How many pixels of the window apart the rays of the next frame are, so that it keeps the
 * time that it is given.
 *
 * The time of a frame is taken to go with its rays. That holds where fragments cost most; where cells
 * do, a frame becomes coarser than it would need to be.
 */
class ImageSampling
{
public:
  /// Pixels from ray to ray in x and in y, 1 for all rays.
  struct Limits
  {
    double Least = 1.0;
    double Greatest = 10.0;
  };

  /// A frame's viewport of so many pixels, of which every `Distance`-th has a ray in x and in y.
  struct Rays
  {
    double Pixels = 1.0;
    double Distance = 1.0;
  };

  /// Choice for a frame that may take `seconds`; before the first frame, and where there is time as
  /// at rest, the least one.
  double Choose(double seconds, double pixels, const Limits& limits) const;

  /// Takes what a frame took.
  void Record(const Rays& rays, double seconds) { this->SecondsPerRay = PerRay(rays, seconds); }
  /// Takes that a frame was given up after so long.
  void RecordGivenUp(const Rays& rays, double seconds);

private:
  static double PerRay(const Rays& rays, double seconds)
  {
    return seconds * rays.Distance * rays.Distance / rays.Pixels;
  }
  /// 0 where it is not known.
  double SecondsPerRay = 0.0;
};

#endif
