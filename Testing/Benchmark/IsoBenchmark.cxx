#include "IsoBenchmark.h"

#include "BenchmarkScene.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkBarycentricShellMapper.h"
#include "vtkContour3DLinearGrid.h"
#include "vtkContourFilter.h"
#include "vtkContourValues.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstdio>
#include <memory>

namespace
{
// One way to draw the surface in a window of its own.
struct Contender
{
  std::string Name;
  std::unique_ptr<BenchmarkScene> Scene;
  vtkSmartPointer<vtkAlgorithm> Contour;
  std::vector<double> Seconds;
};

double ValueOf(vtkUnstructuredGrid* grid)
{
  double range[2];
  grid->GetScalarRange(range);
  return 0.5 * (range[0] + range[1]);
}

Contender MakeOwn(vtkUnstructuredGrid* grid, int size, bool shaded)
{
  vtkNew<vtkBarycentricShellMapper> mapper;
  mapper->SetBlendModeToIsoSurface();
  Contender own{ "this mapper", std::make_unique<BenchmarkScene>(mapper, grid, size), nullptr, {} };
  vtkVolumeProperty* property = own.Scene->Volume->GetProperty();
  property->GetIsoSurfaceValues()->SetValue(0, ValueOf(grid));
  property->GetScalarOpacity()->RemoveAllPoints();
  property->GetScalarOpacity()->AddPoint(0.0, 1.0);
  property->SetShade(shaded ? 1 : 0);
  return own;
}

Contender MakeContour(const std::string& name, vtkSmartPointer<vtkAlgorithm> contour,
  vtkUnstructuredGrid* grid, int size, bool shaded)
{
  // A scene with the same camera, whose volume is not drawn.
  vtkNew<vtkBarycentricShellMapper> unused;
  Contender other{ name, std::make_unique<BenchmarkScene>(unused, grid, size), contour, {} };
  other.Scene->Volume->VisibilityOff();
  contour->SetInputDataObject(grid);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(contour->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetLighting(shaded);
  other.Scene->Renderer->AddActor(actor);
  return other;
}

template <class Filter>
vtkSmartPointer<Filter> MakeFilter(vtkUnstructuredGrid* grid, bool shaded)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetValue(0, ValueOf(grid));
  filter->SetComputeNormals(shaded);
  return filter;
}

std::vector<Contender> MakeContenders(vtkUnstructuredGrid* grid, int size, bool shaded)
{
  std::vector<Contender> all;
  all.push_back(MakeOwn(grid, size, shaded));
  all.push_back(MakeContour("vtkContourFilter", MakeFilter<vtkContourFilter>(grid, shaded), grid,
    size, shaded));
  auto linear = MakeFilter<vtkContour3DLinearGrid>(grid, shaded);
  all.push_back(MakeContour("vtkContour3DLinearGrid", linear, grid, size, shaded));
  auto merged = MakeFilter<vtkContour3DLinearGrid>(grid, shaded);
  merged->MergePointsOn();
  all.push_back(MakeContour("the same, points merged", merged, grid, size, shaded));
  return all;
}

// The camera brings pipelines up to date: points are new after it, and the frame pays for them.
void TimeFrame(Contender& contender, vtkUnstructuredGrid* grid, int frame)
{
  contender.Scene->MoveEye(frame);
  grid->GetPoints()->Modified();
  grid->Modified();
  const double seconds = contender.Scene->TimeRender();
  if (frame > 0)
  {
    contender.Seconds.push_back(seconds);
  }
}

void Compare(vtkUnstructuredGrid* grid, int size, bool shaded, int frames)
{
  std::vector<Contender> all = MakeContenders(grid, size, shaded);
  for (int frame = 0; frame <= frames; ++frame)
  {
    for (Contender& contender : all)
    {
      TimeFrame(contender, grid, frame);
    }
  }
  const vtkIdType triangles = vtkPolyData::SafeDownCast(all[1].Contour->GetOutputDataObject(0))->GetNumberOfPolys();
  const double own = Median(all[0].Seconds);

  std::printf("%d x %d pixels, %s, %lld triangles\n", size, size, shaded ? "shaded" : "not shaded",
    static_cast<long long>(triangles));
  for (const Contender& contender : all)
  {
    std::printf("  %-26s %8.2f ms  %6.2f times as long\n", contender.Name.c_str(),
      1e3 * Median(contender.Seconds), Median(contender.Seconds) / own);
  }
}
}

//------------------------------------------------------------------------------
void IsoBenchmark::Run(const std::string& name, vtkUnstructuredGrid* tetrahedra, int frames)
{
  std::printf("%s, %lld tetrahedra, an iso-surface, %d frames, moved points in each\n",
    name.c_str(), static_cast<long long>(tetrahedra->GetNumberOfCells()), frames);
  for (const bool shaded : { false, true })
  {
    for (const int size : { 128, 512 })
    {
      Compare(tetrahedra, size, shaded, frames);
    }
  }
}
