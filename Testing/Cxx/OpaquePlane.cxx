#include "OpaquePlane.h"

#include "vtkActor.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

namespace
{
vtkSmartPointer<vtkActor> AddActor(TestScene& scene, double left, double right)
{
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(-2.0, -2.0, left);
  source->SetPoint1(2.0, -2.0, right);
  source->SetPoint2(-2.0, 2.0, left);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  scene.Renderer->AddActor(actor);
  return actor;
}
}

//------------------------------------------------------------------------------
void OpaquePlane::Add(TestScene& scene, double left, double right)
{
  AddActor(scene, left, right);
}

//------------------------------------------------------------------------------
void OpaquePlane::AddSlanted(TestScene& scene)
{
  auto actor = AddActor(scene, -0.4, 0.4);
  actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  actor->GetProperty()->LightingOff();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkFloatArray> OpaquePlane::DepthsOfSlanted(TestScene& scene)
{
  const int* size = scene.Renderer->GetSize();
  const double* range = scene.Renderer->GetActiveCamera()->GetClippingRange();
  auto depths = vtkSmartPointer<vtkFloatArray>::New();
  for (int pixel = 0; pixel < size[0] * size[1]; ++pixel)
  {
    const double worldX = 0.9 * (2.0 * (pixel % size[0] + 0.5) / size[0] - 1.0);
    const double distance = 2.0 - 0.2 * worldX;
    depths->InsertNextValue(static_cast<float>((distance - range[0]) / (range[1] - range[0])));
  }
  return depths;
}
