#include "ReportMethods.h"

#include "vtkBarycentricShellMapper.h"
#include "vtkCellCenterDepthSort.h"
#include "vtkMPVOVisibilitySort.h"
#include "vtkMaximumProjectionMapper.h"
#include "vtkNew.h"
#include "vtkPowerVisibilitySort.h"
#include "vtkPreIntegratedTetrahedraMapper.h"
#include "vtkProjectedPolyhedraMapper.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkUnstructuredGridHomogeneousRayIntegrator.h"
#include "vtkUnstructuredGridLinearRayIntegrator.h"
#include "vtkUnstructuredGridPartialPreIntegration.h"
#include "vtkUnstructuredGridPreIntegration.h"
#include "vtkUnstructuredGridVolumeRayCastMapper.h"
#include "vtkUnstructuredGridVolumeZSweepMapper.h"

#include <algorithm>
#include <cstddef>

namespace ReportMethods
{
const char* const Reference = "VTK projected tetrahedra";
const char* const ShirleyTuchman = "ShirleyTuchman";
}

namespace
{
using ReportMethods::Method;
using MapperPointer = vtkSmartPointer<vtkUnstructuredGridVolumeMapper>;
using Ours = vtkPreIntegratedTetrahedraMapper;
using SortPointer = vtkSmartPointer<vtkVisibilitySort>;

const char* const Chosen = "chosen";
const char* const None = "none";

SortPointer MakeSort(const std::string& name)
{
  if (name == "MPVO")
  {
    return vtkSmartPointer<vtkMPVOVisibilitySort>::New();
  }
  if (name == "Power")
  {
    return vtkSmartPointer<vtkPowerVisibilitySort>::New();
  }
  return name == "CellCenter" ? SortPointer(vtkSmartPointer<vtkCellCenterDepthSort>::New())
                              : nullptr;
}

// `set` says what the mapper is to do; it counts misordered faces where its sort can.
Method OurTetrahedra(const std::string& curve, const std::string& setting,
  const std::function<void(Ours*)>& set, const std::string& sort = Chosen,
  const std::string& engine = "Raster")
{
  return { curve, setting, engine, sort, true,
    [=]
    {
      auto mapper = vtkSmartPointer<Ours>::New();
      mapper->SetEngine(engine == "Tiles" ? Ours::TILES : Ours::RASTER);
      mapper->SetVisibilitySort(MakeSort(sort));
      set(mapper);
      return mapper;
    } };
}

Method TheirTetrahedra(const std::string& setting, const std::string& sort)
{
  return { ReportMethods::Reference, setting, "OpenGL", sort, true,
    [=]
    {
      auto mapper = vtkSmartPointer<vtkProjectedTetrahedraMapper>::New();
      mapper->SetVisibilitySort(MakeSort(sort));
      return mapper;
    } };
}

void AddIntegrations(std::vector<Method>& all)
{
  all.push_back(OurTetrahedra("Exact, Raster", "", [](Ours*) {}));
  all.push_back(OurTetrahedra("Exact, Tiles", "", [](Ours*) {}, Chosen, "Tiles"));
  for (const int size : { 64, 128, 256 })
  {
    all.push_back(OurTetrahedra("Table", std::to_string(size),
      [size](Ours* mapper)
      {
        mapper->SetIntegrationToTable();
        mapper->SetTableSize(size);
      }));
  }
  all.push_back(OurTetrahedra("Table, 4 samples", "128",
    [](Ours* mapper)
    {
      mapper->SetIntegrationToTable();
      mapper->SetSamplesPerSegment(4);
    }));
  all.push_back(OurTetrahedra("Average", "", [](Ours* mapper) { mapper->SetIntegrationToAverage(); }));
  for (const char* sort : { "MPVO", "Power", "CellCenter" })
  {
    all.push_back(OurTetrahedra("Exact, Raster", sort, [](Ours*) {}, sort));
  }
}

void AddApproximations(std::vector<Method>& all)
{
  const char* const names[] = { ReportMethods::ShirleyTuchman, "ShirleyTuchmanExponential", "Voxel",
    "UniformThickness1", "UniformThickness2", "Centroid" };
  for (int i = 0; i < 6; ++i)
  {
    all.push_back(
      OurTetrahedra(names[i], "", [i](Ours* mapper) { mapper->SetApproximation(i + 1); }));
    all.back().IsApproximation = true;
  }
}

void AddShells(std::vector<Method>& all)
{
  for (const int samples : { 200, 400, 800 })
  {
    all.push_back({ "Shells", std::to_string(samples), "Raster", None, true,
      [samples]
      {
        auto mapper = vtkSmartPointer<vtkBarycentricShellMapper>::New();
        mapper->SetSamplesPerRay(samples);
        return mapper;
      } });
  }
  all.push_back({ "Shells, point", "400", "Raster", None, true,
    []
    {
      auto mapper = vtkSmartPointer<vtkBarycentricShellMapper>::New();
      mapper->SetIntegrationToPoint();
      return mapper;
    } });
  all.push_back({ "Cell projection, barycentric", "", "Raster", Chosen, true,
    []
    {
      auto mapper = vtkSmartPointer<vtkBarycentricShellMapper>::New();
      mapper->SetMethodToCellProjection();
      return mapper;
    } });
}

void AddUnsorted(std::vector<Method>& all)
{
  auto makePolyhedra = [](int passes, bool average)
  {
    auto mapper = vtkSmartPointer<vtkProjectedPolyhedraMapper>::New();
    mapper->SetPasses(passes);
    mapper->SetAverageEmission(average);
    return mapper;
  };
  all.push_back({ "Emission, one pass", "", "Raster", None, false,
    [=] { return makePolyhedra(1, false); } });
  all.push_back({ "Emission, one pass, mean", "", "Raster", None, false,
    [=] { return makePolyhedra(1, true); } });
  all.push_back({ "Emission, three passes", "", "Raster", None, false,
    [=] { return makePolyhedra(3, false); } });
  all.push_back({ "Maximum", "", "Raster", None, false,
    [] { return vtkSmartPointer<vtkMaximumProjectionMapper>::New(); } });
}

template <class RayCaster, class Integrator>
void AddRayCaster(std::vector<Method>& all, const std::string& curve, const std::string& setting)
{
  all.push_back({ curve, setting, "CPU", None, true,
    []
    {
      auto mapper = vtkSmartPointer<RayCaster>::New();
      vtkNew<Integrator> integrator;
      mapper->SetRayIntegrator(integrator);
      // A ray for every pixel, as all others.
      mapper->AutoAdjustSampleDistancesOff();
      mapper->SetImageSampleDistance(1.0f);
      return mapper;
    } });
}

template <class RayCaster>
void AddRayCasters(std::vector<Method>& all, const std::string& curve)
{
  AddRayCaster<RayCaster, vtkUnstructuredGridHomogeneousRayIntegrator>(all, curve, "Homogeneous");
  AddRayCaster<RayCaster, vtkUnstructuredGridLinearRayIntegrator>(all, curve, "Linear");
  AddRayCaster<RayCaster, vtkUnstructuredGridPartialPreIntegration>(
    all, curve, "PartialPreIntegration");
  AddRayCaster<RayCaster, vtkUnstructuredGridPreIntegration>(all, curve, "PreIntegration");
}
}

namespace ReportMethods
{
//------------------------------------------------------------------------------
std::vector<Method> All()
{
  std::vector<Method> all{ TheirTetrahedra("", "CellCenter"), TheirTetrahedra("MPVO", "MPVO") };
  AddIntegrations(all);
  AddApproximations(all);
  AddShells(all);
  AddUnsorted(all);
  AddRayCasters<vtkUnstructuredGridVolumeRayCastMapper>(all, "VTK Bunyk");
  const std::size_t others = all.size();
  AddRayCasters<vtkUnstructuredGridVolumeZSweepMapper>(all, "VTK ZSweep");
  std::for_each(all.begin() + others, all.end(), [](Method& sweep) { sweep.EndsInside = false; });
  return all;
}

//------------------------------------------------------------------------------
std::vector<Method> Few()
{
  std::vector<Method> few{ TheirTetrahedra("", "CellCenter"),
    OurTetrahedra("Exact, Raster", "", [](Ours*) {}) };
  few.push_back(OurTetrahedra(ReportMethods::ShirleyTuchman, "",
    [](Ours* mapper) { mapper->SetApproximationToShirleyTuchman(); }));
  few.back().IsApproximation = true;
  return few;
}

//------------------------------------------------------------------------------
std::vector<Method> OfLevels(const std::vector<double>& percents)
{
  std::vector<Method> levels;
  for (const double percent : percents)
  {
    const std::string setting = std::to_string(static_cast<int>(percent)) + " %";
    levels.push_back(OurTetrahedra("Simplified, ShirleyTuchman", setting,
      [](Ours* mapper) { mapper->SetApproximationToShirleyTuchman(); }));
    levels.push_back(
      OurTetrahedra("Simplified, Exact, Tiles", setting, [](Ours*) {}, Chosen, "Tiles"));
  }
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    levels[i].Simplified = percents[i / 2];
    levels[i].IsApproximation = true;
  }
  return levels;
}
}
