#include "ViewEye.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// The point that a projection's rows x, y and w all send to zero: everything on a ray through it
// lands on one pixel.
void FindCenter(vtkMatrix4x4* projection, double center[4])
{
  const int rows[3] = { 0, 1, 3 };
  for (int skipped = 0; skipped < 4; ++skipped)
  {
    double minor[3][3];
    for (int r = 0; r < 3; ++r)
    {
      for (int c = 0, column = 0; column < 4; ++column)
      {
        if (column != skipped)
        {
          minor[r][c++] = projection->GetElement(rows[r], column);
        }
      }
    }
    const double determinant = vtkMath::Determinant3x3(minor);
    center[skipped] = skipped % 2 == 0 ? determinant : -determinant;
  }
}
}

namespace ViewEye
{
//------------------------------------------------------------------------------
bool Find(vtkCamera* camera, vtkMatrix4x4* worldToModel, double eye[4])
{
  double inView[4];
  FindCenter(camera->GetProjectionTransformMatrix(1.0, -1.0, 1.0), inView);
  if (camera->GetParallelProjection())
  {
    // Of the two directions, the one towards the eye: the view looks along -z.
    inView[3] = 0.0;
    const double sign = inView[2] < 0.0 ? -1.0 : 1.0;
    std::for_each(inView, inView + 3, [sign](double& x) { x *= sign; });
  }
  vtkMatrix4x4* viewToWorld = camera->GetModelViewTransformMatrix()->NewInstance();
  vtkMatrix4x4::Invert(camera->GetModelViewTransformMatrix(), viewToWorld);
  viewToWorld->MultiplyPoint(inView, eye);
  viewToWorld->Delete();
  worldToModel->MultiplyPoint(eye, eye);
  const double w = camera->GetParallelProjection() ? vtkMath::Norm(eye) : eye[3];
  for (int i = 0; i < 4; ++i)
  {
    eye[i] /= w;
  }
  eye[3] = camera->GetParallelProjection() ? 0.0 : 1.0;
  return std::abs(w) > std::numeric_limits<double>::min() &&
         std::all_of(eye, eye + 4, [](double x) { return std::isfinite(x); });
}
}
