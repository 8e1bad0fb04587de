/**
 * Read-only coordinates as doubles, from any array, from any thread: plain float and double arrays
 * are read in place, without a virtual call; all others through vtkDataArray::GetTuple.
 */
#ifndef PointCoordinates_h
#define PointCoordinates_h

#include "vtkAOSDataArrayTemplate.h"

class PointCoordinates
{
public:
  /** The array, of three components, must outlive this object. */
  explicit PointCoordinates(vtkDataArray* array)
    : Array(array)
  {
    if (auto* floats = vtkArrayDownCast<vtkAOSDataArrayTemplate<float>>(array))
    {
      this->Floats = floats->GetPointer(0);
    }
    else if (auto* doubles = vtkArrayDownCast<vtkAOSDataArrayTemplate<double>>(array))
    {
      this->Doubles = doubles->GetPointer(0);
    }
  }

  void Get(vtkIdType point, double x[3]) const
  {
    if (this->Floats)
    {
      Copy(this->Floats + 3 * point, x);
    }
    else if (this->Doubles)
    {
      Copy(this->Doubles + 3 * point, x);
    }
    else
    {
      this->Array->GetTuple(point, x);
    }
  }

private:
  template <typename Value>
  static void Copy(const Value* from, double to[3])
  {
    to[0] = from[0];
    to[1] = from[1];
    to[2] = from[2];
  }

  vtkDataArray* Array;
  const float* Floats = nullptr;
  const double* Doubles = nullptr;
};

#endif
