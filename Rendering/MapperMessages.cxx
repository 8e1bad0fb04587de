#include "MapperMessages.h"

#include "ScalarField.h"
#include "vtkDataArray.h"
#include "vtkUnstructuredGridBase.h"

namespace MapperMessages
{
//------------------------------------------------------------------------------
std::string InputProblem(vtkUnstructuredGridBase* input)
{
  if (!input)
  {
    return "No input: call SetInputData or SetInputConnection with an unstructured grid.";
  }
  if (input->GetNumberOfPoints() == 0 || input->GetNumberOfCells() == 0)
  {
    return "The input has " + std::to_string(input->GetNumberOfPoints()) + " points and " +
           std::to_string(input->GetNumberOfCells()) + " cells: there is nothing to draw.";
  }
  return "";
}

//------------------------------------------------------------------------------
std::string NonFiniteScalars(vtkDataArray* array, const ScalarField& scalars)
{
  const std::string name = array->GetName() ? array->GetName() : "(without a name)";
  return "Array " + name + " holds " + std::to_string(scalars.NumberOfNonFiniteValues) + " of " +
         std::to_string(array->GetNumberOfTuples()) + " values that are not finite: " +
         (scalars.OnePerCell ? "these cells" : "the cells at these points") + " are skipped.";
}
}
