#include "OracleLightReader.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkVolumeProperty.h"

//------------------------------------------------------------------------------
OracleShading OracleLightReader::Read(vtkVolumeProperty* property, vtkLightCollection* lights) const
{
  OracleShading shading;
  shading.Ambient = property->GetAmbient();
  shading.Diffuse = property->GetDiffuse();
  shading.Specular = property->GetSpecular();
  shading.Power = property->GetSpecularPower();
  vtkNew<vtkLight> headlight;
  headlight->SetLightTypeToHeadlight();
  const int count = lights ? lights->GetNumberOfItems() : 1;
  for (int i = 0; i < count; ++i)
  {
    auto* light = lights ? vtkLight::SafeDownCast(lights->GetItemAsObject(i)) : headlight.Get();
    OracleLight read;
    if (light->GetSwitch() && this->Read(light, read))
    {
      shading.Lights.push_back(read);
    }
  }
  return shading;
}

//------------------------------------------------------------------------------
bool OracleLightReader::Read(vtkLight* light, OracleLight& read) const
{
  const bool isHeadlight = light->LightTypeIsHeadlight() != 0;
  read.Position =
    this->Place(light, isHeadlight ? this->Camera->GetPosition() : light->GetPosition());
  const OracleVector way =
    this->Place(light, isHeadlight ? this->Camera->GetFocalPoint() : light->GetFocalPoint()) -
    read.Position;
  read.IsPositional = light->GetPositional() != 0;
  // VTK's cone angle is half of the cone's; from 90 degrees on there is none.
  read.IsSpot = read.IsPositional && light->GetConeAngle() < 90.0;
  read.Direction = way * (1.0 / way.Length());
  read.ConeCosine = std::cos(vtkMath::RadiansFromDegrees(light->GetConeAngle()));
  read.Exponent = light->GetExponent();
  for (int i = 0; i < 3; ++i)
  {
    read.Attenuation[i] = light->GetAttenuationValues()[i];
    read.Ambient[i] = light->GetIntensity() * light->GetAmbientColor()[i];
    read.Diffuse[i] = light->GetIntensity() * light->GetDiffuseColor()[i];
    read.Specular[i] = light->GetIntensity() * light->GetSpecularColor()[i];
  }
  return way.Length() > 0.0 || (read.IsPositional && !read.IsSpot);
}

//------------------------------------------------------------------------------
OracleVector OracleLightReader::Place(vtkLight* light, const double position[3]) const
{
  vtkMatrix4x4* matrix = light->LightTypeIsCameraLight()
                           ? this->Camera->GetCameraLightTransformMatrix()
                           : light->GetTransformMatrix();
  double point[4] = { position[0], position[1], position[2], 1.0 };
  if (matrix)
  {
    matrix->MultiplyPoint(point, point);
  }
  return OracleVector{ point[0], point[1], point[2] } - this->Center;
}
