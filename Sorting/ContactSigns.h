/**
 * On which side of each contact's plane the eye lies.
 *
 * From planes in floats with a bound on their error; where the bound does not decide, exactly
 * (ExactOrientation). Parallel, and the signs do not depend on the threads.
 */
#ifndef ContactSigns_h
#define ContactSigns_h

#include "CellComplex.h"
#include "vtkType.h"

#include <array>
#include <vector>

class ContactSigns
{
public:
  /** `points`: three per point, to stay as they are. `center` and `size`: of the mesh. */
  void Build(const std::vector<double>& points, const std::vector<CellComplex::Contact>& contacts,
    const double center[3], double size);

  /** `eye`: a point where eye[3] is 1, a direction towards the eye where it is 0. True where a sign
   *  has changed. */
  bool Update(const std::vector<CellComplex::Contact>& contacts, const double eye[4]);

  /** 1 where the eye lies on the side of the contact's first cell, -1 on the other, 0 in its
   *  plane; for the number after the last contact's 0: no contact. */
  signed char operator[](int contact) const { return this->Signs[contact]; }

private:
  void SetPlane(const CellComplex::Contact& contact, vtkIdType at);
  int UpdateRounded(vtkIdType begin, vtkIdType end, const float eye[4], float bound);
  int DecideExactly(const std::vector<CellComplex::Contact>& contacts, vtkIdType begin,
    vtkIdType end, const double eye[4]);

  const std::vector<double>* Points = nullptr;
  double Center[3] = { 0.0, 0.0, 0.0 };
  double Scale = 1.0;
  /** About the centre, in units of the size: x, y and z of the normals, offsets. */
  std::array<std::vector<float>, 4> Planes;
  std::vector<signed char> Signs;
};

#endif
