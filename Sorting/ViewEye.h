/**
 * Where a camera sees from.
 */
#ifndef ViewEye_h
#define ViewEye_h

class vtkCamera;
class vtkMatrix4x4;

namespace ViewEye
{
/** The centre of projection in the coordinates that `worldToModel` leads to: a point (eye[3] = 1),
 *  in parallel projection the direction towards the eye (eye[3] = 0). Sheared and off-axis
 *  projections included. False where there is none. */
bool Find(vtkCamera* camera, vtkMatrix4x4* worldToModel, double eye[4]);
}

#endif
