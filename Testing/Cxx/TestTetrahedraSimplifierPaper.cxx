// Table 4 of Cignoni et al. 1995: no more tetrahedra than the paper keeps of Bucky ball and Blunt
// Fin, with errors measured apart.

#include "ConvexCellsTesting.h"
#include "SimplificationCheck.h"

#include "vtkAppendFilter.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiBlockPLOT3DReader.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <fstream>
#include <string>

using namespace ConvexCellsTesting;

namespace
{
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

Grid TetrahedraOf(vtkUnstructuredGrid* grid)
{
  return Run(grid, true)->GetOutput();
}

Grid ReadBuckyBall()
{
  const char* folder = std::getenv("CELLPROJECTION_DATA");
  std::ifstream file(std::string(folder ? folder : "") + "/Bucky.raw", std::ios::binary);
  vtkNew<vtkUnsignedCharArray> values;
  values->SetName("density");
  values->SetNumberOfValues(32 * 32 * 32);
  if (!file.read(reinterpret_cast<char*>(values->GetPointer(0)), 32 * 32 * 32))
  {
    std::cout << "Bucky.raw is not there\n";
    return nullptr;
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(32, 32, 32);
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkAppendFilter> append;
  append->SetInputData(image);
  append->Update();
  return TetrahedraOf(append->GetOutput());
}

Grid ReadBluntFin()
{
  const char* folder = std::getenv("CELLPROJECTION_DATA");
  const std::string stem = std::string(folder ? folder : "") + "/bluntfin";
  if (!std::ifstream(stem + "q.bin"))
  {
    std::cout << "bluntfinq.bin is not there\n";
    return nullptr;
  }
  vtkNew<vtkMultiBlockPLOT3DReader> reader;
  reader->SetXYZFileName((stem + "xyz.bin").c_str());
  reader->SetQFileName((stem + "q.bin").c_str());
  reader->SetScalarFunctionNumber(100);
  reader->Update();
  vtkNew<vtkAppendFilter> append;
  append->SetInputData(reader->GetOutput()->GetBlock(0));
  append->Update();
  return TetrahedraOf(append->GetOutput());
}

// Table 4 of Cignoni et al. 1995, in tetrahedra that are kept.
void TestPaper()
{
  if (const Grid bucky = ReadBuckyBall())
  {
    CHECK(SimplificationCheck::Check("Bucky ball", bucky, 0.02, 0.0) <= 63649.0 / 176687.0);
    CHECK(SimplificationCheck::Check("Bucky ball", bucky, 0.05, 0.0) <= 35909.0 / 176687.0);
    CHECK(SimplificationCheck::Check("Bucky ball", bucky, 0.1, 0.0) <= 18567.0 / 176687.0);
  }
  if (const Grid tetrahedra = ReadBluntFin())
  {
    CHECK(SimplificationCheck::Check("Blunt Fin", tetrahedra, 0.02, 0.001) <= 13094.0 / 187395.0);
    CHECK(SimplificationCheck::Check("Blunt Fin", tetrahedra, 0.04, 0.001) <= 5615.0 / 187395.0);
    CHECK(SimplificationCheck::Check("Blunt Fin", tetrahedra, 0.06, 0.001) <= 2796.0 / 187395.0);
  }
}
}

int TestTetrahedraSimplifierPaper(int, char*[])
{
  TestPaper();
  return Result();
}
