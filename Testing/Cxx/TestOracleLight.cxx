/**
 * Shading and gradient opacity of a box with a scalar that is linear: its gradient is the same
 * everywhere, so that a directional light changes the colour by a factor, and gradient opacity the
 * extinction. Headlights, camera and scene lights, several, spots and attenuation, moved volumes.
 */

#include "TestOracleScene.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"

namespace
{
using Color = std::array<double, 3>;

/** 2 x - y + 0.5 z, with the gradient (2, -1, 0.5). */
double Ramp(double x, double y, double z)
{
  return 2.0 * x - y + 0.5 * z;
}

class LitScene : public TestOracleScene
{
public:
  vtkNew<vtkLightCollection> Lights;
  TestOracleBox Box;
  double Gradient[3] = { 2.0, -1.0, 0.5 };

  LitScene()
  {
    this->Box.CellType = VTK_TETRA;
    this->Box.Field = Ramp;
    this->Volume->GetProperty()->ShadeOn();
    this->Volume->GetProperty()->SetAmbient(0.15);
    this->Volume->GetProperty()->SetDiffuse(0.6);
    this->Volume->GetProperty()->SetSpecular(0.4);
    this->Volume->GetProperty()->SetSpecularPower(3.0);
    this->Oracle->SetLights(this->Lights);
    this->Camera->ParallelProjectionOn();
  }

  vtkLight* AddLight(double x, double y, double z)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(x, y, z);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    this->Lights->AddItem(light);
    return light;
  }

  /** |n.l| and (r.v)^3 for a light whose direction, towards it, is given, at one pixel. */
  std::array<double, 2> GetCosines(const double toLight[3], int column, int row) const
  {
    double start[3], toEye[3], axis, normal[3] = { this->Gradient[0], this->Gradient[1],
      this->Gradient[2] };
    this->GetRay(column, row, start, toEye, axis);
    vtkMath::MultiplyScalar(toEye, -1.0);
    vtkMath::Normalize(normal);
    const double cosine = vtkMath::Dot(normal, toLight);
    // The angle between v and the mirrored l: cos = 2 (n.l)(n.v) - l.v.
    const double highlight =
      2.0 * cosine * vtkMath::Dot(normal, toEye) - vtkMath::Dot(toLight, toEye);
    return { std::abs(cosine), std::pow(std::max(highlight, 0.0), 3.0) };
  }
};

/** Every pixel is alpha times a colour; `shade` gives it from the pixel. */
void CheckImage(TestOracleChecks& checks, LitScene& scene,
  const std::function<Color(int column, int row)>& shade, double extinction = 0.8)
{
  CHECK_TRUE(checks, scene.Draw(scene.Box.Build()));
  int covered = 0;
  for (int row = 0; row < scene.Height; ++row)
  {
    for (int column = 0; column < scene.Width; ++column)
    {
      const std::array<double, 2> interval = scene.GetInterval(column, row, scene.Box.Bounds);
      const double alpha = -std::expm1(-extinction * std::max(0.0, interval[1] - interval[0]));
      covered += alpha > 0.0;
      const Color color = shade(column, row);
      CHECK_NEAR(checks, scene.GetValue(column, row, 3), alpha, 1e-9);
      for (int i = 0; i < 3; ++i)
      {
        CHECK_NEAR(checks, scene.GetValue(column, row, i), alpha * color[i], 1e-9);
      }
    }
  }
  CHECK_TRUE(checks, covered > 20);
}

Color Shade(const LitScene& scene, const std::array<double, 2>& cosines)
{
  Color color;
  for (int i = 0; i < 3; ++i)
  {
    color[i] = scene.Kappa[i] * (0.15 + 0.6 * cosines[0]) + 0.4 * cosines[1];
  }
  return color;
}

/** The headlight: l is the view axis reversed. */
void CheckHeadlight(TestOracleChecks& checks)
{
  LitScene scene;
  double toLight[3];
  vtkMath::Subtract(scene.Camera->GetPosition(), scene.Camera->GetFocalPoint(), toLight);
  vtkMath::Normalize(toLight);
  const auto shade = [&](int column, int row)
  { return Shade(scene, scene.GetCosines(toLight, column, row)); };
  vtkNew<vtkLight> headlight;
  headlight->SetLightTypeToHeadlight();
  scene.Lights->AddItem(headlight);
  CheckImage(checks, scene, shade);
  scene.Camera->ParallelProjectionOff();
  CheckImage(checks, scene, shade);
  // None given is the same.
  scene.Oracle->SetLights(nullptr);
  CheckImage(checks, scene, shade);
}

/** Two scene lights with colours and intensities, one that is off and one with no direction. */
void CheckSeveral(TestOracleChecks& checks)
{
  LitScene scene;
  const double directions[2][3] = { { 0.6, 0.0, 0.8 }, { 0.0, -1.0, 0.0 } };
  for (const double* direction : directions)
  {
    scene.AddLight(direction[0], direction[1], direction[2])->SetColor(1.0, 0.5, 0.25);
  }
  vtkLight* second = vtkLight::SafeDownCast(scene.Lights->GetItemAsObject(1));
  second->SetIntensity(0.5);
  second->SetAmbientColor(0.2, 0.2, 0.2);
  scene.AddLight(1.0, 1.0, 1.0)->SwitchOff();
  scene.AddLight(0.0, 0.0, 0.0);
  CheckImage(checks, scene,
    [&](int column, int row)
    {
      const Color first = Shade(scene, scene.GetCosines(directions[0], column, row));
      const Color other = Shade(scene, scene.GetCosines(directions[1], column, row));
      const double tint[3] = { 1.0, 0.5, 0.25 };
      Color color;
      for (int i = 0; i < 3; ++i)
      {
        color[i] = tint[i] * (first[i] + 0.5 * other[i]) + scene.Kappa[i] * 0.15 * 0.5 * 0.2;
      }
      return color;
    });
}

/** A volume that is scaled and turned: the gradient is carried by the inverse transpose. */
void CheckMatrix(TestOracleChecks& checks)
{
  LitScene scene;
  scene.AddLight(0.6, 0.0, 0.8);
  scene.Volume->SetScale(0.5, 1.0, 2.0);
  const double toLight[3] = { 0.6, 0.0, 0.8 };
  const double moved[3] = { 2.0 / 0.5, -1.0, 0.5 / 2.0 };
  std::copy_n(moved, 3, scene.Gradient);
  CheckImage(checks, scene, [&](int column, int row)
    { return Shade(scene, scene.GetCosines(toLight, column, row)); });
}

/** Gradient opacity is by the length of the world's gradient. */
void CheckGradientOpacity(TestOracleChecks& checks)
{
  LitScene scene;
  scene.Volume->GetProperty()->ShadeOff();
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, 0.0);
  function->AddPoint(10.0, 1.0);
  scene.Volume->GetProperty()->SetGradientOpacity(function);
  const auto shade = [&](int, int) { return scene.Kappa; };
  CheckImage(checks, scene, shade, 0.08 * std::sqrt(5.25));
  scene.Volume->SetScale(0.5);
  CheckImage(checks, scene, shade, 0.08 * 2.0 * std::sqrt(5.25));
  scene.Volume->GetProperty()->DisableGradientOpacityOn();
  CheckImage(checks, scene, shade, 0.8);
}

/** A thin sheet before a spot at the distance d: the light there is closed form. */
void CheckSpot(TestOracleChecks& checks)
{
  LitScene scene;
  scene.Box.Bounds = { -1.0, 1.0, -1.0, 1.0, -1e-6, 1e-6 };
  scene.Box.Field = [](double, double, double z) { return z; };
  scene.SetExtinction(1e5);
  scene.Camera->SetPosition(0.0, 0.0, 5.0);
  scene.Camera->SetFocalPoint(0.0, 0.0, 0.0);
  scene.Volume->GetProperty()->SetSpecular(0.0);
  vtkLight* light = scene.AddLight(0.2, 0.1, 0.7);
  light->SetFocalPoint(0.2, 0.1, 0.0);
  light->PositionalOn();
  light->SetConeAngle(40.0);
  light->SetExponent(2.0);
  light->SetAttenuationValues(0.5, 0.25, 2.0);
  CHECK_TRUE(checks, scene.Draw(scene.Box.Build()));
  int inside = 0;
  for (int row = 0; row < scene.Height; ++row)
  {
    for (int column = 0; column < scene.Width; ++column)
    {
      double start[3], direction[3], axis;
      scene.GetRay(column, row, start, direction, axis);
      const double x = start[0] - 0.2, y = start[1] - 0.1;
      const double distance = std::sqrt(x * x + y * y + 0.49);
      const double cosine = 0.7 / distance;
      const bool lit = cosine > std::cos(vtkMath::RadiansFromDegrees(40.0));
      const double share = 1.0 / (0.5 + 0.25 * distance + 2.0 * distance * distance);
      const double factor = lit ? cosine * cosine * share * (0.15 + 0.6 * cosine) : 0.0;
      const double alpha = scene.GetValue(column, row, 3);
      inside += lit && alpha > 0.1;
      CHECK_NEAR(checks, scene.GetValue(column, row, 0), alpha * scene.Kappa[0] * factor, 1e-5);
    }
  }
  CHECK_TRUE(checks, inside > 20);
}

/** A camera light stays with the camera: above it by its own fixed coordinates. */
void CheckCameraLight(TestOracleChecks& checks)
{
  LitScene scene;
  scene.Camera->SetPosition(0.0, 0.0, 5.0);
  scene.Camera->SetFocalPoint(0.0, 0.0, 0.0);
  vtkLight* light = scene.AddLight(0.0, 1.0, 0.0);
  light->SetLightTypeToCameraLight();
  const double above[3] = { 0.0, 1.0, 0.0 }, turned[3] = { 1.0, 0.0, 0.0 };
  CheckImage(checks, scene, [&](int column, int row)
    { return Shade(scene, scene.GetCosines(above, column, row)); });
  scene.Camera->SetViewUp(1.0, 0.0, 0.0);
  CheckImage(checks, scene, [&](int column, int row)
    { return Shade(scene, scene.GetCosines(turned, column, row)); });
}

/** A vertex has the mean of its tetrahedra, by volume: one of them three times as high. */
void CheckWeights(TestOracleChecks& checks)
{
  LitScene scene;
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> scalars;
  // A tent over the triangle z = 0: up to z = 3 on one side, down to z = -1 on the other.
  const double places[5][3] = { { -1, -1, 0 }, { 1, -1, 0 }, { 0, 1, 0 }, { 0, 0, 3 }, { 0, 0, -1 } };
  for (const double* place : places)
  {
    points->InsertNextPoint(place);
    scalars->InsertNextValue(std::abs(place[2]));
  }
  grid->SetPoints(points);
  grid->GetPointData()->SetScalars(scalars);
  const vtkIdType cells[2][4] = { { 0, 1, 2, 3 }, { 0, 1, 2, 4 } };
  grid->InsertNextCell(VTK_TETRA, 4, cells[0]);
  grid->InsertNextCell(VTK_TETRA, 4, cells[1]);
  // The gradients are (0, 0, 1) and (0, 0, -1): 1/2 up on the triangle, and linear from there.
  vtkNew<vtkPiecewiseFunction> function;
  function->AddPoint(0.0, 0.0);
  function->AddPoint(1.0, 1.0);
  scene.Volume->GetProperty()->ShadeOff();
  scene.Volume->GetProperty()->SetGradientOpacity(function);
  scene.Camera->SetPosition(0.0, 0.0, 5.0);
  scene.Camera->SetFocalPoint(0.0, 0.0, 0.0);
  scene.Oracle->SetSize(1, 1);
  CHECK_TRUE(checks, scene.Draw(grid));
  // Above: int 1/2 + z / 6 over 3 = 2.25. Below: |1/2 - 3/2 t| over 1 = 1/12 + 1/3.
  const double depth = 0.8 * (2.25 + 1.0 / 12.0 + 1.0 / 3.0);
  CHECK_NEAR(checks, scene.GetValue(0, 0, 3), -std::expm1(-depth), 1e-9);
}
}

int TestOracleLight(int, char*[])
{
  TestOracleChecks checks("TestOracleLight");
  CheckHeadlight(checks);
  CheckSeveral(checks);
  CheckMatrix(checks);
  CheckGradientOpacity(checks);
  CheckSpot(checks);
  CheckCameraLight(checks);
  CheckWeights(checks);
  return checks.GetResult();
}
