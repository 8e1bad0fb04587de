#ifndef IsoSurfaces_h
#define IsoSurfaces_h

#include "IsoRaster.h"
#include "IsoTriangles.h"
#include "ShadingBuffers.h"
#include "VolumeShading.h"

#include <string>
#include <vector>

class ElementBuffers;
struct CellProjectionFrame;
struct PreparedVolume;

/**
 * @class IsoSurfaces
 * @brief The iso-surfaces that a volume's property asks for, from its values to the window's depth.
 *
 * Where all of them are opaque, they are drawn as triangles: these are made again where points,
 * scalars, cells or values change.
 */
class IsoSurfaces
{
public:
  IsoSurfaces();

  /// Takes the values; what cannot be drawn is named in `problems`.
  void TakeValues(const CellProjectionFrame& frame, const PreparedVolume& prepared,
    std::vector<std::string>& problems);

  /// Whether no surface passes between these normalised scalars.
  bool IsEmpty(float low, float high) const;

  /// Whether triangles are drawn: after TakeValues.
  bool AreTriangles() const { return this->IsOpaque; }
  /// `corners`: 4 ids per cell, made at `cornersTime`.
  void MakeTriangles(const PreparedVolume& prepared, const std::vector<int>& corners,
    const vtkTimeStamp& cornersTime);
  const IsoTriangles& GetTriangles() const { return this->Triangles; }
  const vtkTimeStamp& GetCutTime() const { return this->TriangleSource.CutTime; }
  const IsoTriangleRaster& GetTriangleRaster() const { return this->Raster.GetTriangles(); }
  /// After MakeTriangles, into the window and its depth: no image, and no DrawDepth.
  bool DrawIntoWindow(const CellProjectionFrame& frame, const PreparedVolume& prepared,
    const std::vector<int>& corners, const vtkTimeStamp& cornersTime);

  /// `vertices`, as ElementLists gives them, where there are no triangles. Into
  /// the bound framebuffer; false, with the reason in GetFailure, where it cannot.
  bool Draw(const CellProjectionFrame& frame, const PreparedVolume& prepared,
    const std::vector<int>& corners, const vtkTimeStamp& cornersTime,
    const std::vector<int>& vertices, ElementBuffers& buffers);

  /// After the frame's image has been blended into the window: joins its depth.
  void DrawDepth(const CellProjectionFrame& frame);

  void ReleaseGraphicsResources(vtkWindow* window);
  const std::string& GetFailure() const { return this->Failure; }

private:
  IsoRaster::View MakeView(const CellProjectionFrame& frame, const PreparedVolume& prepared);
  bool Shade(const CellProjectionFrame& frame, const PreparedVolume& prepared,
    const std::vector<int>& corners, const vtkTimeStamp& cornersTime);
  void CheckValues(
    int count, int skipped, bool onePerCell, std::vector<std::string>& problems);
  void ShadeTriangles(const PreparedVolume& prepared);

  IsoTriangles Triangles;
  IsoTriangleRaster::Source TriangleSource;
  std::vector<float> CutValues;
  std::vector<int> WantedPoints;
  vtkTimeStamp WantedTime;
  bool WantsAllPoints = true;

  VolumeShading Shading;
  ShadingBuffers Buffers;
  IsoRaster Raster;
  std::vector<float> Values;
  std::array<float, 2> Depths{ { 0.0f, 1.0f } };
  bool IsOpaque = false;
  std::string Failure;
};

#endif
