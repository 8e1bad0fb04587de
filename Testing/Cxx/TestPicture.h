#ifndef TestPicture_h
#define TestPicture_h

#include "vtkRenderWindow.h"

/**
 * Whether what `window` shows agrees with the baseline that the test's arguments name.
 *
 * One threshold for every window class, driver and version of VTK: the colours of a pixel, 0 to
 * 255, may differ by `PictureTolerance` in sum, and the parts above that, over the whole picture,
 * add up to no more than one pixel going from black to white. Prints that figure; on a failure the
 * picture and the difference are written into the tests' folder.
 */
bool AgreesWithBaseline(int argc, char* argv[], vtkRenderWindow* window);

#endif
