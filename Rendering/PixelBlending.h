/**
 * Premultiplied colours in floats over those of a window in bytes, in memory.
 */
#ifndef PixelBlending_h
#define PixelBlending_h

namespace PixelBlending
{
/** Lays `count` pixels of RGBA over as many of `window`, each 0 to 255: all four become
 *  image + window (1 - alpha), 1 at most, rounded to the nearest. What the image has below 0 or above
 *  1 is cut off as in any framebuffer of bytes; what is no number counts as 0. */
void LayOver(const float* image, int count, unsigned char* window);
}

#endif
