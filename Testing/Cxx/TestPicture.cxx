#include "TestPicture.h"

#include "vtkImageDifference.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkTesting.h"
#include "vtkWindowToImageFilter.h"

#include <iostream>
#include <string>

namespace
{
const int PictureTolerance = 3;

void Write(vtkAlgorithm* source, const std::string& path)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(source->GetOutputPort());
  writer->SetFileName(path.c_str());
  writer->Write();
  std::cout << "written: " << path << "\n";
}
}

bool AgreesWithBaseline(int argc, char* argv[], vtkRenderWindow* window)
{
  vtkNew<vtkTesting> testing;
  testing->AddArguments(argc, argv);
  vtkNew<vtkPNGReader> baseline;
  baseline->SetFileName(testing->GetValidImageFileName());
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  vtkNew<vtkImageDifference> difference;
  difference->SetInputConnection(picture->GetOutputPort());
  difference->SetImageConnection(baseline->GetOutputPort());
  difference->AllowShiftOff();
  difference->AveragingOff();
  difference->SetThreshold(PictureTolerance);
  difference->Update();
  std::cout << "difference: " << difference->GetError() << ", above " << PictureTolerance << ": "
            << difference->GetThresholdedError() << "\n";
  const bool agrees = difference->GetThresholdedError() <= 1.0;
  if (!agrees)
  {
    const std::string folder = std::string(testing->GetTempDirectory()) + "/" + argv[0];
    Write(picture, folder + ".png");
    Write(difference, folder + ".difference.png");
  }
  return agrees;
}
