#include "VolumePropertyReader.h"

#include "FiniteNodes.h"
#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkScalarsToColors.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
// Nodes, and the midpoints where a sharp function jumps, of either kind of function. A node's
// midpoint is the last but one of its values, its sharpness the last.
template <class Function>
void AppendNodes(Function* function, int valuesPerNode, std::vector<double>& candidates)
{
  double node[6];
  double previous = 0.0;
  double midpoint = 0.5;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    function->GetNodeValue(i, node);
    candidates.push_back(node[0]);
    if (i > 0)
    {
      candidates.push_back(previous + midpoint * (node[0] - previous));
    }
    previous = node[0];
    midpoint = node[valuesPerNode - 2];
  }
}

void AppendProblem(int count, const std::string& what, std::vector<std::string>& problems)
{
  if (count > 0)
  {
    problems.push_back(std::to_string(count) + " points of the property's " + what);
  }
}
}

//------------------------------------------------------------------------------
VolumePropertyReader::VolumePropertyReader(vtkVolumeProperty* property)
  : Property(property)
  , Opacity(FiniteNodes::Copy(property->GetScalarOpacity()))
{
  if (property->GetColorChannels() == 1)
  {
    this->Gray = FiniteNodes::Copy(property->GetGrayTransferFunction());
  }
  else
  {
    this->Color = FiniteNodes::Copy(property->GetRGBTransferFunction());
  }
}

//------------------------------------------------------------------------------
void VolumePropertyReader::CheckNodes(std::vector<std::string>& problems) const
{
  const std::string remedy = " function are not finite: drawn without them; remove them.";
  AppendProblem(FiniteNodes::CountBad(this->Property->GetScalarOpacity()),
    "scalar opacity" + remedy, problems);
  AppendProblem(this->Gray ? FiniteNodes::CountBad(this->Property->GetGrayTransferFunction())
                           : FiniteNodes::CountBad(this->Property->GetRGBTransferFunction()),
    (this->Gray ? "gray" : "colour") + remedy, problems);
  int below = 0;
  for (int i = 0; i < this->Opacity->GetSize(); ++i)
  {
    double node[4];
    this->Opacity->GetNodeValue(i, node);
    below += node[1] < 0.0 ? 1 : 0;
  }
  AppendProblem(below,
    "scalar opacity function are below 0: what is below counts as 0; raise them.", problems);
}

//------------------------------------------------------------------------------
void VolumePropertyReader::CheckFunctions(std::vector<std::string>& problems)
{
  this->CheckNodes(problems);
  this->HasOpacity = this->Opacity->GetSize() > 0;
  if (!this->HasOpacity)
  {
    problems.emplace_back(
      "The property's scalar opacity function has no points: drawn with opacity "
      "1; add points to it.");
  }
  this->HasColor = this->Gray ? this->Gray->GetSize() > 0 : this->Color->GetSize() > 0;
  if (!this->HasColor)
  {
    problems.emplace_back(std::string("The property's ") + (this->Gray ? "gray" : "colour") +
                          " function has no points: drawn in white; add points to it.");
  }
}

//------------------------------------------------------------------------------
double VolumePropertyReader::CheckUnitDistance(std::vector<std::string>& problems) const
{
  const double distance = this->Property->GetScalarOpacityUnitDistance();
  if (distance > 0.0 && std::isfinite(distance))
  {
    return distance;
  }
  problems.push_back("The property's ScalarOpacityUnitDistance is " + std::to_string(distance) +
                     ": drawn with 1; it must be positive.");
  return 1.0;
}

//------------------------------------------------------------------------------
VolumePropertyReader::Source VolumePropertyReader::FindSource() const
{
  vtkObject* color = this->Property->GetColorChannels() == 1
                       ? static_cast<vtkObject*>(this->Property->GetGrayTransferFunction())
                       : this->Property->GetRGBTransferFunction();
  vtkObject* opacity = this->Property->GetScalarOpacity();
  return { color, opacity, std::max(color->GetMTime(), opacity->GetMTime()),
    this->Property->GetScalarOpacityUnitDistance() };
}

//------------------------------------------------------------------------------
std::array<double, 2> VolumePropertyReader::FindLimits() const
{
  const std::vector<double> candidates = this->FindCandidates();
  const auto ends = std::minmax_element(candidates.begin(), candidates.end());
  return candidates.empty() ? std::array<double, 2>{ { 0.0, 0.0 } }
                            : std::array<double, 2>{ { *ends.first, *ends.second } };
}

//------------------------------------------------------------------------------
void VolumePropertyReader::Read(const double range[2], const double extremes[2], bool onePerCell,
  bool isOpacityPerLength, TransferFunction& function, std::vector<std::string>& problems)
{
  this->CheckFunctions(problems);
  const double distance = isOpacityPerLength ? this->CheckUnitDistance(problems) : 1.0;
  function.Build(
    this->FindCandidates(), [this](double scalar) { return this->Evaluate(scalar); }, range,
    extremes, distance,
    onePerCell ? TransferFunction::Steps::OfCells : TransferFunction::Steps::OfPoints);
}

//------------------------------------------------------------------------------
std::vector<double> VolumePropertyReader::FindCandidates() const
{
  std::vector<double> candidates;
  AppendNodes(this->Opacity.GetPointer(), 4, candidates);
  if (this->Gray)
  {
    AppendNodes(this->Gray.GetPointer(), 4, candidates);
  }
  else
  {
    AppendNodes(this->Color.GetPointer(), 6, candidates);
  }
  return candidates;
}

//------------------------------------------------------------------------------
TransferFunction::Sample VolumePropertyReader::Evaluate(double scalar) const
{
  TransferFunction::Sample sample{ { 1.0, 1.0, 1.0, 1.0 } };
  if (this->HasColor && this->Gray)
  {
    sample[0] = sample[1] = sample[2] = this->Gray->GetValue(scalar);
  }
  else if (this->HasColor)
  {
    this->Color->GetColor(scalar, sample.data());
  }
  if (this->HasOpacity)
  {
    sample[3] = std::max(this->Opacity->GetValue(scalar), 0.0);
  }
  return sample;
}

//------------------------------------------------------------------------------
bool VolumePropertyReader::HasDependentComponents(int numberOfComponents) const
{
  return !this->Property->GetIndependentComponents() &&
         (numberOfComponents == 2 || numberOfComponents == 4);
}

//------------------------------------------------------------------------------
int VolumePropertyReader::ChooseComponent(int numberOfComponents, bool canDepend) const
{
  if (canDepend && this->HasDependentComponents(numberOfComponents))
  {
    return numberOfComponents - 1;
  }
  if (numberOfComponents <= 1 || this->Property->GetColorChannels() == 1)
  {
    return 0;
  }
  vtkColorTransferFunction* color = this->Property->GetRGBTransferFunction();
  if (color->GetVectorMode() == vtkScalarsToColors::MAGNITUDE)
  {
    return -1;
  }
  return std::min(std::max(color->GetVectorComponent(), 0), numberOfComponents - 1);
}

//------------------------------------------------------------------------------
bool VolumePropertyReader::HasGradientOpacity() const
{
  if (this->Property->GetDisableGradientOpacity() || !this->Property->HasGradientOpacity())
  {
    return false;
  }
  // Asking a property for its gradient opacity creates one that is 1 everywhere: that asks for
  // nothing.
  const auto function = FiniteNodes::Copy(this->Property->GetGradientOpacity());
  double node[4];
  bool effective = function->GetSize() > 0 && !function->GetClamping();
  for (int i = 0; i < function->GetSize(); ++i)
  {
    function->GetNodeValue(i, node);
    effective = effective || node[1] != 1.0;
  }
  return effective;
}

//------------------------------------------------------------------------------
double VolumePropertyReader::ReadGradientOpacity(TransferFunction& function) const
{
  const auto opacity = FiniteNodes::Copy(this->Property->GetGradientOpacity());
  std::vector<double> candidates;
  AppendNodes(opacity.GetPointer(), 4, candidates);
  const double greatest = *std::max_element(candidates.begin(), candidates.end());
  const double range[2] = { 0.0, greatest > 0.0 ? greatest : 1.0 };
  const double extremes[2] = { 0.0, 2.0 * range[1] };
  const auto evaluate = [opacity](double gradient) {
    return TransferFunction::Sample{ { 0.0, 0.0, 0.0,
      std::max(opacity->GetValue(gradient), 0.0) } };
  };
  function.Build(candidates, evaluate, range, extremes, 1.0);
  return range[1];
}

//------------------------------------------------------------------------------
std::vector<std::string> VolumePropertyReader::FindUnsupported(
  int numberOfComponents, bool onePerCell, bool canShade, bool canDepend) const
{
  std::vector<std::string> unsupported;
  if (this->Property->GetShade() && !canShade)
  {
    unsupported.emplace_back("Shade is on: drawn unlit; call ShadeOff().");
  }
  if (this->HasGradientOpacity() && !canShade)
  {
    unsupported.emplace_back("A gradient opacity function is set: it is not applied; call "
                             "DisableGradientOpacityOn().");
  }
  if (!onePerCell && this->Property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION)
  {
    unsupported.emplace_back("Interpolation is nearest, the property's default: point scalars are "
                             "drawn linear; call SetInterpolationTypeToLinear().");
  }
  if (this->Property->GetTransferFunctionMode() == vtkVolumeProperty::TF_2D)
  {
    unsupported.emplace_back("A two-dimensional transfer function is set: the one-dimensional "
                             "functions are drawn; call SetTransferFunctionMode(TF_1D).");
  }
  if (numberOfComponents > 1 && !this->Property->GetIndependentComponents() &&
      !(canDepend && this->HasDependentComponents(numberOfComponents)))
  {
    unsupported.emplace_back("IndependentComponents is off: one component of " +
                             std::to_string(numberOfComponents) +
                             " is drawn; call IndependentComponentsOn().");
  }
  return unsupported;
}
