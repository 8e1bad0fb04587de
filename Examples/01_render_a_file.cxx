// The C++ twin of 01_render_a_file.py: renders a .vtu to a PNG.
//   01_render_a_file mesh.vtu picture.png

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPreIntegratedTetrahedraMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <vtkWindowToImageFilter.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "usage: " << argv[0] << " mesh.vtu picture.png\n";
    return 1;
  }
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(argv[1]);
  reader->Update();
  const double* range = reader->GetOutput()->GetScalarRange();

  vtkNew<vtkVolume> volume;
  vtkVolumeProperty* property = volume->GetProperty();
  property->SetInterpolationTypeToLinear();
  property->SetScalarOpacityUnitDistance(reader->GetOutput()->GetLength() / 10.0);
  property->GetRGBTransferFunction()->AddRGBPoint(range[0], 0.1, 0.4, 1.0);
  property->GetRGBTransferFunction()->AddRGBPoint(range[1], 1.0, 0.4, 0.1);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(range[0], 0.05);
  opacity->AddPoint(range[1], 0.8);
  property->SetScalarOpacity(opacity);

  vtkNew<vtkPreIntegratedTetrahedraMapper> mapper;
  mapper->SetInputConnection(reader->GetOutputPort());
  volume->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(640, 480);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->SetFileName(argv[2]);
  writer->Write();
  return 0;
}
