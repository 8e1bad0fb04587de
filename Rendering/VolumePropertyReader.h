#ifndef VolumePropertyReader_h
#define VolumePropertyReader_h

#include "TransferFunction.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkColorTransferFunction;
class vtkPiecewiseFunction;
class vtkVolumeProperty;

/**
 * @class VolumePropertyReader
 * @brief Takes the transfer function, and whatever is asked for and not drawn, from a property.
 *
 * Nodes that are not finite are left out, opacities below 0 count as 0.
 */
class VolumePropertyReader
{
public:
  explicit VolumePropertyReader(vtkVolumeProperty* property);

  /// What the transfer function is made of; equal sources make equal functions.
  struct Source
  {
    const void* Color = nullptr;
    const void* Opacity = nullptr;
    vtkMTimeType Time = 0;
    double UnitDistance = 0.0;

    bool operator==(const Source& other) const
    {
      return this->Color == other.Color && this->Opacity == other.Opacity &&
             this->Time == other.Time && this->UnitDistance == other.UnitDistance;
    }
  };
  Source FindSource() const;

  /// Between these scalars the functions change; beyond they are constant.
  std::array<double, 2> FindLimits() const;

  /// Builds `function` for scalars normalised over `range`, `extremes` the least and greatest,
  /// `onePerCell` constant in each cell.
  /// Without `isOpacityPerLength` its extinction is the scalar opacity itself.
  /// Problems with the property (a function without points, a unit distance of zero) are appended
  /// to `problems`, one sentence each, with what was drawn instead.
  void Read(const double range[2], const double extremes[2], bool onePerCell,
    bool isOpacityPerLength, TransferFunction& function, std::vector<std::string>& problems);

  /// What the property asks for and is not drawn; `canShade`: shading and gradient
  /// opacity are; `canDepend`: dependent components are.
  std::vector<std::string> FindUnsupported(
    int numberOfComponents, bool onePerCell, bool canShade, bool canDepend) const;

  /// False where it is disabled or 1 everywhere.
  bool HasGradientOpacity() const;

  /// Builds `function` over the gradient's length, normalised; returns what 1 stands for.
  double ReadGradientOpacity(TransferFunction& function) const;

  /// Which of an array's components the property wants; -1 is the magnitude. `canDepend`: of
  /// dependent components the last one, by opacity.
  int ChooseComponent(int numberOfComponents, bool canDepend) const;

  /// True for two or four components with IndependentComponents off.
  bool HasDependentComponents(int numberOfComponents) const;

private:
  std::vector<double> FindCandidates() const;
  TransferFunction::Sample Evaluate(double scalar) const;
  double CheckUnitDistance(std::vector<std::string>& problems) const;
  void CheckFunctions(std::vector<std::string>& problems);
  void CheckNodes(std::vector<std::string>& problems) const;

  vtkVolumeProperty* Property;
  vtkSmartPointer<vtkPiecewiseFunction> Opacity;
  /// One of them is null.
  vtkSmartPointer<vtkPiecewiseFunction> Gray;
  vtkSmartPointer<vtkColorTransferFunction> Color;
  bool HasColor = true;
  bool HasOpacity = true;
};

#endif
