#ifndef TetrahedraSelection_h
#define TetrahedraSelection_h

#include "vtkType.h"

#include <functional>
#include <vector>

class ScalarField;
class TransferFunction;
class vtkUnstructuredGrid;

/**
 * @class TetrahedraSelection
 * @brief The corners of a mesh's tetrahedra, and which of them are worth drawing.
 */
class TetrahedraSelection
{
public:
  /// Corners: 4 point ids per cell, ascending, so that cells agree on the planes of shared faces.
  void TakeCorners(vtkUnstructuredGrid* tetrahedra);

  /// Finds the cells with a scalar that is not finite and those the transfer function leaves empty.
  void Classify(const ScalarField& scalars, const TransferFunction& function);

  /// The same where `isEmpty` says whether a cell whose scalars reach from `low` to `high`,
  /// normalised, changes no pixel.
  using Emptiness = std::function<bool(float low, float high)>;
  void Classify(const ScalarField& scalars, const Emptiness& isEmpty);

  /// All of them, whatever their scalars.
  void TakeAll();

  bool IsDrawn(vtkIdType cell) const { return this->Classes[cell] == Drawn; }
  vtkIdType GetNumberOfCells() const { return static_cast<vtkIdType>(this->Corners.size() / 4); }

  std::vector<int> Corners;
  vtkIdType NumberOfTransparentCells = 0;
  vtkIdType NumberOfInvalidCells = 0;

private:
  enum Class : unsigned char
  {
    Drawn,
    Transparent,
    Invalid
  };
  Class ClassOf(vtkIdType cell, const ScalarField& scalars, const Emptiness& isEmpty) const;

  std::vector<Class> Classes;
};

#endif
