#ifndef ReportMethods_h
#define ReportMethods_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkUnstructuredGridVolumeMapper;

/// The rows of the report: every mapper, integration, approximation, sort and engine.
namespace ReportMethods
{
struct Method
{
  /// Whose points are one curve of the plots, and what tells those points apart.
  std::string Curve;
  std::string Setting;
  /// "Raster", "Tiles"; of VTK's mappers what they draw with.
  std::string Engine;
  std::string Sort;
  /// Draws tetrahedra, else the mesh as it is.
  bool NeedsTetrahedra;
  std::function<vtkSmartPointer<vtkUnstructuredGridVolumeMapper>()> Make;
  /// Compared with Shirley's and Tuchman's image too.
  bool IsApproximation = false;
  /// Percent of field error that the tetrahedra are simplified by; 0: not at all.
  double Simplified = 0.0;
  /// A frame of it from inside the mesh comes to an end.
  bool EndsInside = true;
};

/// VTK's projected tetrahedra come first, Shirley's and Tuchman's before the other approximations.
std::vector<Method> All();

/// VTK's, exact ones and Shirley's and Tuchman's.
std::vector<Method> Few();

/// Simplified meshes, drawn by the standard method as in the paper, and exactly.
std::vector<Method> OfLevels(const std::vector<double>& percents);

extern const char* const Reference;
extern const char* const ShirleyTuchman;
}

#endif
