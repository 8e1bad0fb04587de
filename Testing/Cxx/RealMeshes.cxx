#include "RealMeshes.h"

#include "vtkAppendFilter.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiBlockPLOT3DReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridReader.h"
#if VTK_MODULE_ENABLE_VTK_IOExodus
#include "vtkExodusIIReader.h"
#endif

#include <cstdlib>
#include <fstream>
#include <iostream>

namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

// Without data.
Grid Collect(vtkDataObject* data)
{
  auto grid = Grid::New();
  grid->CopyStructure(RealMeshes::Append(data));
  return grid;
}

Grid ReadPlot3D(const std::string& stem)
{
  vtkNew<vtkMultiBlockPLOT3DReader> reader;
  reader->SetXYZFileName((stem + "xyz.bin").c_str());
  reader->AutoDetectFormatOn();
  reader->Update();
  return Collect(reader->GetOutput());
}

Grid ReadXML(const std::string& file)
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return Collect(reader->GetOutput());
}

Grid ReadExodus(const std::string& file)
{
#if VTK_MODULE_ENABLE_VTK_IOExodus
  vtkNew<vtkExodusIIReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return Collect(reader->GetOutput());
#else
  std::cout << "skipped: no reader for " << file << "\n";
  return nullptr;
#endif
}
}

//------------------------------------------------------------------------------
Grid RealMeshes::Read(const std::string& name)
{
  const char* variable = std::getenv("CELLPROJECTION_DATA");
  const std::string folder = std::string(variable ? variable : ".") + "/";
  const std::string stem = name == "bluntFin" ? "bluntfin" : name;
  const bool structured = name == "bluntFin" || name == "comb" || name == "post";
  const std::string file = folder + (structured        ? stem + "xyz.bin"
                                      : name == "can"  ? "can.vtu"
                                      : name == "fire" ? "fire_ug.vtu"
                                                       : "disk_out_ref.ex2");
  if (!std::ifstream(file))
  {
    std::cout << "skipped: CELLPROJECTION_DATA names no folder with " << name << "\n";
    return nullptr;
  }
  return structured          ? ReadPlot3D(folder + stem)
         : name == "diskOut" ? ReadExodus(file)
                             : ReadXML(file);
}

//------------------------------------------------------------------------------
Grid RealMeshes::Append(vtkDataObject* data)
{
  vtkNew<vtkAppendFilter> append;
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    auto iterator = vtk::TakeSmartPointer(blocks->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      append->AddInputData(vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject()));
    }
  }
  else
  {
    append->AddInputData(vtkDataSet::SafeDownCast(data));
  }
  append->Update();
  return append->GetOutput();
}
