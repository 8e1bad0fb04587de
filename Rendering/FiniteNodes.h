#ifndef FiniteNodes_h
#define FiniteNodes_h

#include "vtkSmartPointer.h"

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

/// A function of a property without the nodes of which a value is not finite: itself where all are.
class FiniteNodes
{
public:
  /// How many nodes there are.
  static int CountBad(vtkPiecewiseFunction* function);
  static int CountBad(vtkColorTransferFunction* function);

  /// Nodes at one scalar stay steps.
  static vtkSmartPointer<vtkPiecewiseFunction> Copy(vtkPiecewiseFunction* function);
  static vtkSmartPointer<vtkColorTransferFunction> Copy(vtkColorTransferFunction* function);
};

#endif
