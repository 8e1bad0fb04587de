#ifndef PlainPixelStore_h
#define PlainPixelStore_h

#include <array>

/**
 * @class PlainPixelStore
 * @brief While it lives pixels go from and to memory row by row without gaps, whatever strides and
 * buffers others have set; then those are set again.
 *
 * It needs a current context. For pixels of four or sixteen bytes: rows begin at multiples of four.
 */
class PlainPixelStore
{
public:
  PlainPixelStore();
  ~PlainPixelStore();
  PlainPixelStore(const PlainPixelStore&) = delete;
  void operator=(const PlainPixelStore&) = delete;

private:
  static constexpr int Count = 10;
  std::array<int, Count> Before;
  int BuffersBefore[2];
};

#endif
