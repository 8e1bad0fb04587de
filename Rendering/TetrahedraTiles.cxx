#include "TetrahedraTiles.h"

#include "BackToFrontOrder.h"
#include "CellProjectionFrame.h"
#include "PreparedVolume.h"
#include "TetrahedraSelection.h"
#include "TilesFrame.h"
#include "VolumeShading.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <string>

//------------------------------------------------------------------------------
void TetrahedraTiles::Update(const PreparedVolume& prepared, const TetrahedraSelection& selection,
  const vtkTimeStamp& selectionTime, const TileMesh::Progress& report)
{
  const bool newCells = this->CellsTime < prepared.CellsTime;
  if (newCells)
  {
    this->Engine.SetMesh(prepared.Coordinates.Points, selection.Corners, report);
    const std::vector<signed char>& orientations = this->Engine.GetMesh().Orientations;
    this->NumberOfFlatCells = std::count(orientations.begin(), orientations.end(), 0);
    this->CellsTime.Modified();
  }
  if (newCells || this->ScalarsTime < prepared.ScalarsTime)
  {
    this->Engine.SetScalars(prepared.Scalars.Values, prepared.Scalars.OnePerCell);
    this->ScalarsTime.Modified();
  }
  if (newCells || this->SelectionTime < selectionTime)
  {
    std::vector<unsigned char> drawn(static_cast<size_t>(selection.GetNumberOfCells()));
    for (vtkIdType cell = 0; cell < selection.GetNumberOfCells(); ++cell)
    {
      drawn[cell] = selection.IsDrawn(cell) ? 1 : 0;
    }
    this->Engine.SetDrawn(drawn);
    this->SelectionTime.Modified();
  }
}

//------------------------------------------------------------------------------
void TetrahedraTiles::UpdateShading(const VolumeShading& shading)
{
  const bool hasGradients = shading.IsLit || shading.HasGradientOpacity;
  if (hasGradients && (this->GradientsTime < this->CellsTime ||
                        this->GradientsTime < shading.GradientsTime))
  {
    this->Engine.SetGradients(shading.Gradients.Values);
    this->GradientsTime.Modified();
  }
  const DependentColors& colors = shading.Colors;
  if (colors.Kind != DependentColors::None &&
      (this->ColorsTime < this->CellsTime || this->ColorsTime < colors.Time))
  {
    this->Engine.SetColors(colors.Values, colors.OnePerCell);
    this->ColorsTime.Modified();
  }
}

//------------------------------------------------------------------------------
const float* TetrahedraTiles::Draw(CellProjectionFrame& frame, const PreparedVolume& prepared,
  const VolumeShading& shading, const BackToFrontOrder* order)
{
  TilesEngine::Scene scene;
  scene.Camera = TilesFrame::GetCamera(frame);
  scene.Function = &prepared.Function;
  scene.Shading = &shading;
  scene.OpaqueDepth = frame.OpaqueDepths;
  scene.ClippingPlanes = frame.ClippingPlanes;
  scene.IsAborted = TilesFrame::GetAbortCheck(frame);
  scene.TimesStages = this->ReportsStages;
  scene.BackToFront = order ? &order->Cells : nullptr;
  if (!this->Engine.Render(scene))
  {
    return nullptr;
  }
  frame.Statistics.CellsSkippedOutside = this->Engine.CountCellsOutside();
  frame.Statistics.CellsDrawn -= frame.Statistics.CellsSkippedOutside;
  frame.Statistics.RepairedPixels = this->Engine.GetCounts().RepairedPixels;
  if (this->ReportsStages)
  {
    this->ReportStages(frame.Statistics);
  }
  return this->Engine.GetImage().data();
}

//------------------------------------------------------------------------------
void TetrahedraTiles::ReportStages(FrameStatistics& statistics) const
{
  for (int stage = 0; stage < TileStages::Other; ++stage)
  {
    statistics.Further.emplace_back(std::string("Seconds") + TileStages::GetName(stage),
      this->Engine.GetStages().Seconds[stage]);
  }
  const TileCounts& counts = this->Engine.GetCounts();
  const auto add = [&](const char* name, double value) { statistics.Further.emplace_back(name, value); };
  add("Threads", vtkSMPTools::GetEstimatedNumberOfThreads());
  add("CellsInTiles", static_cast<double>(this->Engine.CountCellsInTiles()));
  add("CellsHidden", static_cast<double>(counts.HiddenCells));
  add("Fragments", static_cast<double>(counts.Fragments));
  add("Pieces", static_cast<double>(counts.Pieces));
  add("LanesOfBlocks", static_cast<double>(counts.LanesOfBlocks));
  add("LanesCovered", static_cast<double>(counts.CoveredLanes));
  add("LanesShaded", static_cast<double>(counts.ShadedLanes));
  add("BytesOfMesh", static_cast<double>(this->Engine.GetMeshMemory()));
  add("BytesOfFrame", static_cast<double>(this->Engine.GetFrameMemory()));
}
