#include "MapperMessages.h"

#include "DrawnCells.h"
#include "RayUniforms.h"
#include "ScalarField.h"
#include "vtkDataArray.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
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
std::string RendererProblem(vtkRenderer* renderer)
{
  if (!vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()))
  {
    return "The renderer has no OpenGL window: nothing is drawn.";
  }
  if (renderer->GetUseDepthPeeling() && renderer->GetUseDepthPeelingForVolumes())
  {
    return "Volumes are not depth peeled: call UseDepthPeelingForVolumesOff() on the "
           "renderer; nothing is drawn.";
  }
  return "";
}

//------------------------------------------------------------------------------
std::string ExcessPlanes(vtkPlaneCollection* planes)
{
  const int count = planes ? planes->GetNumberOfItems() : 0;
  if (count <= RayUniforms::MaximumClippingPlanes)
  {
    return "";
  }
  return std::to_string(count) + " clipping planes are set: the first " +
         std::to_string(RayUniforms::MaximumClippingPlanes) + " clip.";
}

//------------------------------------------------------------------------------
std::string FlatTetrahedra(vtkIdType count)
{
  if (count == 0)
  {
    return "";
  }
  return std::to_string(count) +
         " tetrahedra are too small beside the whole mesh for its float coordinates: they are not "
         "drawn; render their part of the mesh on its own.";
}

//------------------------------------------------------------------------------
std::string UnresolvedCells(vtkIdType count)
{
  if (count == 0)
  {
    return "";
  }
  return std::to_string(count) + " cells hide each other in circles of more than " +
         std::to_string(DrawnCells::LargestGroup) +
         ": too many to put in order per pixel, the image is not exact there.";
}

//------------------------------------------------------------------------------
std::string UnreadableDepth(bool isRead)
{
  return isRead ? "" : "The window's depth cannot be read: opaque geometry does not hide the volume.";
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
