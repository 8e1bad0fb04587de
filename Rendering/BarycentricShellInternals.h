#ifndef BarycentricShellInternals_h
#define BarycentricShellInternals_h

#include "BackToFrontOrder.h"
#include "CellProjectionFrame.h"
#include "DrawnCells.h"
#include "ElementBuffers.h"
#include "ElementProjection.h"
#include "IsoSurfaces.h"
#include "MeshExtent.h"
#include "PreparedElements.h"
#include "PreparedVolume.h"
#include "ShellPlan.h"
#include "ShellRaster.h"
#include "vtkBarycentricShellMapper.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkVisibilitySort.h"

#include <memory>
#include <string>
#include <vector>

/// What the mapper keeps from frame to frame.
class vtkBarycentricShellMapper::Internals
{
public:
  PreparedElements Elements;
  ElementBuffers Buffers;

  vtkSmartPointer<vtkImageData> Texture;

  ShellPlan Plan;
  ShellRaster Shells;
  // Of the last frame.
  vtkIdType TargetBytes = 0;
  bool IsInShells = false;
  const std::vector<MeshBlock>* Blocks = nullptr;

  vtkSmartPointer<vtkVisibilitySort> Sort;
  std::unique_ptr<BackToFrontOrder> Order;
  vtkTimeStamp OrderTime;
  ElementProjection Projection;
  DrawnCells Drawn;

  IsoSurfaces Surfaces;
  // What the last frame left for the window's depth.
  CellProjectionFrame SurfacesFrame;
  bool HasSurfaces = false;

  bool DrawShells(const CellProjectionFrame& frame, const PreparedVolume& prepared,
    vtkBarycentricShellMapper& mapper, std::string& failure)
  {
    ShellRaster::View view;
    static_cast<RasterView&>(view) = frame.GetRasterView();
    view.Image = frame.Image;
    view.Plan = &this->Plan;
    view.Cells = &this->Elements.Cells;
    view.Corners = &this->Elements.Selection.Corners;
    view.Blocks = this->Blocks;
    view.Prepared = &prepared;
    view.IsPreIntegrated = mapper.GetIntegration() == PRE_INTEGRATED;
    view.IsTextured = this->Buffers.GetTexture().IsUsed();
    view.Box = MeshExtent::FindScreenBox(prepared.Coordinates, view);
    this->TargetBytes = static_cast<vtkIdType>(sizeof(float)) * 2 * this->Plan.SamplesPerShell *
                        frame.Size[0] * frame.Size[1];
    const bool drawn = this->Shells.Draw(frame.Window, view, this->Buffers);
    this->IsInShells = drawn;
    failure = drawn ? "" : this->Shells.GetFailure();
    return drawn;
  }

  /// Cell projection.
  bool DrawOrdered(
    const CellProjectionFrame& frame, const PreparedVolume& prepared, std::string& failure)
  {
    this->Drawn.Build(*this->Order, this->Elements.Cells);
    const std::vector<int> vertices = this->Elements.MakeVertices(this->Drawn.Cells);
    ElementProjection::View view;
    static_cast<RasterView&>(view) = frame.GetRasterView();
    view.Cells = &this->Drawn;
    view.Vertices = &vertices;
    view.Points = &prepared.Coordinates.Points;
    view.Corners = &this->Elements.Selection.Corners;
    const bool drawn = this->Projection.Draw(frame.Window, view, this->Buffers);
    failure = drawn ? "" : this->Projection.GetFailure();
    return drawn;
  }

  void MakeTriangles(const PreparedVolume& prepared, FrameStatistics& statistics)
  {
    this->Elements.TakeCorners(prepared);
    this->Surfaces.MakeTriangles(
      prepared, this->Elements.Selection.Corners, this->Elements.CornersTime);
    const IsoTriangles& triangles = this->Surfaces.GetTriangles();
    this->Elements.CountTurnedCells(prepared, &triangles.Cells, this->Surfaces.GetCutTime());
    const auto cells = static_cast<vtkIdType>(this->Elements.Selection.Corners.size() / 4);
    const auto cut = static_cast<vtkIdType>(triangles.Cells.size());
    statistics.CellsDrawn = cut - triangles.NumberOfLostCells;
    statistics.CellsSkippedTransparent = cells - cut - triangles.NumberOfInvalidCells;
    statistics.CellsSkippedInvalid += triangles.NumberOfInvalidCells + triangles.NumberOfLostCells;
  }

  bool DrawIntoWindow(
    const CellProjectionFrame& frame, const PreparedVolume& prepared, std::string& failure)
  {
    const bool drawn = this->Surfaces.DrawIntoWindow(
      frame, prepared, this->Elements.Selection.Corners, this->Elements.CornersTime);
    failure = this->Surfaces.GetFailure();
    return drawn;
  }

  bool DrawSurfaces(
    const CellProjectionFrame& frame, const PreparedVolume& prepared, std::string& failure)
  {
    const bool asTriangles = this->Surfaces.AreTriangles();
    this->HasSurfaces = this->Surfaces.Draw(frame, prepared, this->Elements.Selection.Corners,
      this->Elements.CornersTime,
      asTriangles ? std::vector<int>() : this->Elements.MakeVertices(), this->Buffers);
    this->SurfacesFrame = frame;
    failure = this->Surfaces.GetFailure();
    return this->HasSurfaces;
  }
};

#endif
