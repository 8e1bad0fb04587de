// A lit image drawn by vtkGPUVolumeRayCastMapper and the tetrahedra of the same image agree: to .01
// in the mean over the pixels that either draws, where the light is the same one. VTK's headlight is
// at the eye, ours is directional, as it is for surfaces: the eye is far away here; from near by what
// is compared is the mean over the whole picture. VTK's highlight is (n.h)^p in 9.1 and (r.v)^p, as
// ours, in 9.6: where light and eye are in one place (r.v)^p is about (n.h)^(4 p).

#include "TestScene.h"

#include "vtkAppendFilter.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkLight.h"
#include "vtkPointData.h"
#include "vtkRTAnalyticSource.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>

namespace
{
vtkSmartPointer<vtkImageData> Picture(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->Update();
  return grab->GetOutput();
}

struct Means
{
  double Picture = 1.0;
  double Drawn = 1.0;
};

/// The mean of the colours' differences, of 1: over the picture, and where either draws.
Means MeanDifference(vtkImageData* a, vtkImageData* b)
{
  vtkDataArray* colorsA = a->GetPointData()->GetScalars();
  vtkDataArray* colorsB = b->GetPointData()->GetScalars();
  const vtkIdType pixels = colorsA->GetNumberOfTuples();
  double sum = 0.0;
  int drawn = 0;
  for (vtkIdType id = 0; id < pixels; ++id)
  {
    double total = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      sum += std::abs(colorsA->GetComponent(id, i) - colorsB->GetComponent(id, i)) / 765.0;
      total += colorsA->GetComponent(id, i) + colorsB->GetComponent(id, i);
    }
    drawn += total > 0.0 ? 1 : 0;
  }
  return drawn > 100 ? Means{ sum / pixels, sum / drawn } : Means();
}

void SetFunctions(TestScene& scene)
{
  scene.Color->RemoveAllPoints();
  scene.Color->AddRGBPoint(40.0, 0.1, 0.2, 0.9);
  scene.Color->AddRGBPoint(150.0, 0.9, 0.9, 0.2);
  scene.Color->AddRGBPoint(270.0, 0.9, 0.1, 0.1);
  scene.Opacity->RemoveAllPoints();
  scene.Opacity->AddPoint(60.0, 0.0);
  scene.Opacity->AddPoint(270.0, 0.4);
  scene.Property->ShadeOn();
  scene.Property->SetAmbient(0.2);
  scene.Property->SetDiffuse(0.7);
  scene.Property->SetSpecular(0.3);
  scene.Property->SetSpecularPower(10.0);
}

/// The image mapper takes an opacity per unit distance, projected cells an extinction.
void CopyWithOpacity(TestScene& scene, vtkVolumeProperty* property)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  for (int i = 0; i <= 200; ++i)
  {
    const double scalar = 60.0 + 210.0 * i / 200.0;
    opacity->AddPoint(scalar, -std::expm1(-scene.Opacity->GetValue(scalar)));
  }
  property->DeepCopy(scene.Property);
  property->SetScalarOpacity(opacity);
}

/// `powers`: VTK's specular power in ours.
Means Compare(TestScene& scene, vtkGPUVolumeRayCastMapper* caster, double powers = 1.0)
{
  scene.Render();
  auto ours = Picture(scene.Window);
  vtkNew<vtkVolumeProperty> property;
  CopyWithOpacity(scene, property);
  property->SetSpecularPower(powers * scene.Property->GetSpecularPower());
  scene.Volume->SetMapper(caster);
  scene.Volume->SetProperty(property);
  scene.Render();
  const Means means = MeanDifference(ours, Picture(scene.Window));
  scene.Volume->SetMapper(scene.Mapper);
  scene.Volume->SetProperty(scene.Property);
  std::cout << "mean difference " << means.Picture << ", where drawn " << means.Drawn << "\n";
  return means;
}
}

int TestRayCastAgreement(int, char*[])
{
  TestChecks checks;
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-10, 9, -10, 9, -10, 9);
  vtkNew<vtkAppendFilter> voxels;
  voxels->SetInputConnection(wavelet->GetOutputPort());
  voxels->Update();
  TestScene scene(96, 96);
  scene.SetGrid(voxels->GetOutput());
  SetFunctions(scene);
  scene.LookFrom(40.0, 25.0, 55.0);
  scene.Renderer->ResetCameraClippingRange();
  vtkNew<vtkGPUVolumeRayCastMapper> caster;
  caster->SetInputConnection(wavelet->GetOutputPort());
  caster->SetAutoAdjustSampleDistances(false);
  caster->SetSampleDistance(0.1f);
  const Means near = Compare(scene, caster);
  CHECK_AT_MOST(near.Picture, 0.01);
  // So far that all rays are one.
  scene.LookFrom(4000.0, 2500.0, 5500.0);
  scene.Renderer->GetActiveCamera()->SetViewAngle(0.3);
  scene.Renderer->ResetCameraClippingRange();
  const Means reflected = Compare(scene, caster), halfway = Compare(scene, caster, 4.0);
  const double headlight = std::min(reflected.Drawn, halfway.Drawn);
  CHECK_AT_MOST(headlight, 0.01);
  scene.LookFrom(40.0, 25.0, 55.0);
  scene.Renderer->GetActiveCamera()->SetViewAngle(30.0);
  scene.Renderer->ResetCameraClippingRange();
  scene.Property->ShadeOff();
  const Means unlit = Compare(scene, caster);
  CHECK_AT_MOST(unlit.Drawn, 0.003);
  scene.Property->ShadeOn();
  scene.Property->SetSpecular(0.0);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(40.0, 45.0, 30.0);
  scene.Renderer->RemoveAllLights();
  scene.Renderer->AddLight(light);
  // With a light of the scene VTK takes the ambient term from the light's ambient colour alone.
  scene.Property->SetAmbient(0.0);
  const Means sceneLight = Compare(scene, caster);
  CHECK_AT_MOST(sceneLight.Drawn, 0.01);
  // One light from the other side is another picture: what they agree on is the light.
  scene.Render();
  auto before = Picture(scene.Window);
  light->SetPosition(-30.0, 45.0, 40.0);
  scene.Render();
  CHECK(MeanDifference(before, Picture(scene.Window)).Drawn > 0.05);
  return checks.Result();
}
