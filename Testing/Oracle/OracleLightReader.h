/**
 * Lights of a scene and coefficients of a property as an OracleShading.
 *
 * A headlight is where the camera is, a camera light is placed by the camera from the coordinates
 * that VTK documents for it; nobody need have rendered before. Lights that are switched off, and those
 * without the direction that they need, are left out.
 */

#ifndef OracleLightReader_h
#define OracleLightReader_h

#include "OracleShading.h"

class vtkCamera;
class vtkLight;
class vtkLightCollection;
class vtkVolumeProperty;

class OracleLightReader
{
public:
  /** `center`: the world position from which all coordinates count. */
  OracleLightReader(vtkCamera* camera, const OracleVector& center)
    : Camera(camera)
    , Center(center)
  {
  }

  /** Null lights are one white headlight. */
  OracleShading Read(vtkVolumeProperty* property, vtkLightCollection* lights) const;

private:
  bool Read(vtkLight* light, OracleLight& read) const;
  OracleVector Place(vtkLight* light, const double position[3]) const;

  vtkCamera* Camera;
  OracleVector Center;
};

#endif
