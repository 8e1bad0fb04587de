#include "ReportMeshes.h"

#include "MeshLattice.h"
#include "RealMeshes.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiBlockPLOT3DReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridReader.h"
#if VTK_MODULE_ENABLE_VTK_IOExodus
#include "vtkExodusIIReader.h"
#endif
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>

namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

// One grid of all that a reader found, with one of its scalars alone.
Grid Collect(vtkDataObject* data, const char* scalar)
{
  const Grid all = RealMeshes::Append(data);
  auto grid = Grid::New();
  grid->CopyStructure(all);
  vtkPointData* points = all->GetPointData();
  grid->GetPointData()->SetScalars(scalar ? points->GetArray(scalar) : points->GetScalars());
  return grid;
}

Grid ReadBluntFin(const std::string& folder)
{
  vtkNew<vtkMultiBlockPLOT3DReader> reader;
  reader->SetXYZFileName((folder + "bluntfinxyz.bin").c_str());
  reader->SetQFileName((folder + "bluntfinq.bin").c_str());
  reader->SetScalarFunctionNumber(100);
  reader->Update();
  return Collect(reader->GetOutput(), "Density");
}

Grid ReadBuckyBall(const std::string& folder)
{
  vtkNew<vtkImageReader2> reader;
  reader->SetFileName((folder + "Bucky.raw").c_str());
  reader->SetFileDimensionality(3);
  reader->SetDataExtent(0, 31, 0, 31, 0, 31);
  reader->SetDataScalarTypeToUnsignedChar();
  reader->Update();
  return Collect(reader->GetOutput(), nullptr);
}

Grid ReadFirePlume(const std::string& folder)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName((folder + "fire_ug.vtu").c_str());
  reader->Update();
  return Collect(reader->GetOutput(), "t");
}

Grid ReadDiskOut(const std::string& folder)
{
#if VTK_MODULE_ENABLE_VTK_IOExodus
  vtkNew<vtkExodusIIReader> reader;
  reader->SetFileName((folder + "disk_out_ref.ex2").c_str());
  reader->UpdateInformation();
  reader->SetPointResultArrayStatus("Temp", 1);
  reader->Update();
  return Collect(reader->GetOutput(), "Temp");
#else
  return nullptr;
#endif
}

struct Source
{
  const char* Name;
  const char* File;
  std::function<Grid(const std::string&)> Read;
  std::vector<double> Levels;
};

const std::vector<Source>& Sources()
{
  static const std::vector<Source> sources = {
    { "Blunt Fin", "bluntfinxyz.bin", ReadBluntFin, { 2.0, 4.0, 6.0 } },
    { "Bucky ball", "Bucky.raw", ReadBuckyBall, { 2.0, 5.0, 10.0 } },
    { "disk_out_ref", "disk_out_ref.ex2", ReadDiskOut, {} },
    { "fire plume", "fire_ug.vtu", ReadFirePlume, {} },
  };
  return sources;
}
}

namespace ReportMeshes
{
//------------------------------------------------------------------------------
std::vector<Mesh> Read(const std::string& folder, const std::vector<std::string>& names)
{
  std::vector<Mesh> meshes;
  for (const Source& source : Sources())
  {
    if (std::find(names.begin(), names.end(), source.Name) == names.end())
    {
      continue;
    }
    const bool isThere = !folder.empty() && vtksys::SystemTools::FileExists(folder + "/" + source.File);
    Grid grid = isThere ? source.Read(folder + "/") : nullptr;
    if (grid)
    {
      meshes.push_back({ source.Name, grid, source.Levels });
      continue;
    }
    std::cout << "skipped: " << source.Name << ", for which CELLPROJECTION_DATA has no "
              << source.File << " or this VTK no reader" << std::endl;
  }
  return meshes;
}

//------------------------------------------------------------------------------
Mesh MakeLattice(int cells, const std::vector<double>& levels)
{
  MeshLattice lattice(cells, cells, cells);
  lattice.SetMap(
    [cells](const double u[3], double p[3])
    {
      const double angle = 0.8 * u[2] / cells;
      const double x = u[0] / cells - 0.5, y = u[1] / cells - 0.5;
      p[0] = x * std::cos(angle) - y * std::sin(angle);
      p[1] = x * std::sin(angle) + y * std::cos(angle);
      p[2] = u[2] / cells - 0.5;
    });
  Grid grid = lattice.Make();
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("waves");
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    const double* p = grid->GetPoint(id);
    scalars->InsertNextValue(std::sin(7.0 * p[0]) * std::cos(5.0 * p[1]) * std::sin(6.0 * p[2] + 1));
  }
  grid->GetPointData()->SetScalars(scalars);
  return { "lattice", grid, levels };
}
}
