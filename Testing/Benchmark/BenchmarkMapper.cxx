#include "BenchmarkMapper.h"

#include "BenchmarkScene.h"

#include "vtkPreIntegratedTetrahedraMapper.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridVolumeRayCastMapper.h"
#include "vtkUnstructuredGridVolumeZSweepMapper.h"

namespace
{
using MapperPointer = vtkSmartPointer<vtkUnstructuredGridVolumeMapper>;

MapperPointer MakeOurs(int engine)
{
  auto mapper = vtkSmartPointer<vtkPreIntegratedTetrahedraMapper>::New();
  mapper->SetEngine(engine);
  return mapper;
}

template <class RayCaster>
MapperPointer MakeRayCaster()
{
  auto mapper = vtkSmartPointer<RayCaster>::New();
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetImageSampleDistance(1.0f);
  return mapper;
}
}

//------------------------------------------------------------------------------
std::unique_ptr<BenchmarkScene> BenchmarkMapper::Show(
  vtkUnstructuredGrid* grid, int size, bool spiky) const
{
  auto scene = std::make_unique<BenchmarkScene>(this->Make(), grid, size, spiky);
  scene->Volume->GetProperty()->SetShade(this->IsLit);
  return scene;
}

//------------------------------------------------------------------------------
BenchmarkMapper BenchmarkMapper::Tiles()
{
  return { "ours, Tiles", "Tiles", [] { return MakeOurs(vtkConvexCellMapper::TILES); } };
}

//------------------------------------------------------------------------------
BenchmarkMapper BenchmarkMapper::LitTiles()
{
  BenchmarkMapper mapper = BenchmarkMapper::Tiles();
  mapper.Name = "ours, Tiles, lit";
  mapper.IsLit = true;
  return mapper;
}

//------------------------------------------------------------------------------
BenchmarkMapper BenchmarkMapper::Raster()
{
  return { "ours, Raster", "Raster", [] { return MakeOurs(vtkConvexCellMapper::RASTER); } };
}

//------------------------------------------------------------------------------
BenchmarkMapper BenchmarkMapper::ProjectedTetrahedra()
{
  return { "VTK projected tetrahedra", "OpenGL",
    []() -> MapperPointer { return vtkSmartPointer<vtkProjectedTetrahedraMapper>::New(); } };
}

//------------------------------------------------------------------------------
BenchmarkMapper BenchmarkMapper::Bunyk()
{
  return { "VTK Bunyk", "CPU", MakeRayCaster<vtkUnstructuredGridVolumeRayCastMapper> };
}

//------------------------------------------------------------------------------
BenchmarkMapper BenchmarkMapper::ZSweep()
{
  // Rays meet more cells, but there are no more rays.
  return { "VTK ZSweep", "CPU", MakeRayCaster<vtkUnstructuredGridVolumeZSweepMapper>, false, 0.5 };
}
