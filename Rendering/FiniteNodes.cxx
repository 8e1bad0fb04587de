#include "FiniteNodes.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
// Scalar, value, midpoint, sharpness; scalar, red, green, blue, midpoint, sharpness.
using OpacityNode = std::array<double, 4>;
using ColorNode = std::array<double, 6>;

template <class Node>
bool IsFinite(const Node& node)
{
  return std::all_of(node.begin(), node.end(), [](double value) { return std::isfinite(value); });
}

template <class Node, class Function>
int CountBadNodes(Function* function)
{
  int bad = 0;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    Node node;
    function->GetNodeValue(i, node.data());
    bad += IsFinite(node) ? 0 : 1;
  }
  return bad;
}

void Add(vtkPiecewiseFunction* function, const OpacityNode& n)
{
  function->AddPoint(n[0], n[1], n[2], n[3]);
}

void Add(vtkColorTransferFunction* function, const ColorNode& n)
{
  function->AddRGBPoint(n[0], n[1], n[2], n[3], n[4], n[5]);
}

template <class Node, class Function>
vtkSmartPointer<Function> CopyNodes(Function* function)
{
  if (CountBadNodes<Node>(function) == 0)
  {
    return function;
  }
  auto copy = vtkSmartPointer<Function>::New();
  copy->DeepCopy(function);
  copy->RemoveAllPoints();
  copy->AllowDuplicateScalarsOn();
  for (int i = 0; i < function->GetSize(); ++i)
  {
    Node node;
    function->GetNodeValue(i, node.data());
    if (IsFinite(node))
    {
      Add(copy, node);
    }
  }
  return copy;
}
}

//------------------------------------------------------------------------------
int FiniteNodes::CountBad(vtkPiecewiseFunction* function)
{
  return CountBadNodes<OpacityNode>(function);
}

//------------------------------------------------------------------------------
int FiniteNodes::CountBad(vtkColorTransferFunction* function)
{
  return CountBadNodes<ColorNode>(function);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPiecewiseFunction> FiniteNodes::Copy(vtkPiecewiseFunction* function)
{
  return CopyNodes<OpacityNode>(function);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkColorTransferFunction> FiniteNodes::Copy(vtkColorTransferFunction* function)
{
  return CopyNodes<ColorNode>(function);
}
