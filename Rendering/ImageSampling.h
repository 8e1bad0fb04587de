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

  /// Choice for a frame that may take `seconds`; before the first frame the least one.
  double Choose(double seconds, const Limits& limits) const;

  /// Takes what a frame took.
  void Record(double distance, double seconds) { this->FullSeconds = seconds * distance * distance; }

private:
  /// What all rays would take, 0 where it is not known.
  double FullSeconds = 0.0;
};

#endif
