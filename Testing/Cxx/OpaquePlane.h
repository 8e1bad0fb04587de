#ifndef OpaquePlane_h
#define OpaquePlane_h

#include "TestScene.h"

#include "vtkFloatArray.h"
#include "vtkSmartPointer.h"

/// Opaque surfaces in a volume.
namespace OpaquePlane
{
/// A square from (-2, -2) to (2, 2), whose z goes from `left` to `right` along x.
void Add(TestScene& scene, double left, double right);

/// z = .2 x, black in any light.
void AddSlanted(TestScene& scene);
/// The slanted plane's depth at the centre of every pixel of the parallel view from (0, 0, 2), of scale
/// .9.
vtkSmartPointer<vtkFloatArray> DepthsOfSlanted(TestScene& scene);
}

#endif
