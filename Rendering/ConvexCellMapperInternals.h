#ifndef ConvexCellMapperInternals_h
#define ConvexCellMapperInternals_h

#include "CellProjectionFrame.h"
#include "CoarseImage.h"
#include "FloatTarget.h"
#include "ImageSampling.h"
#include "MapperInput.h"
#include "OpaqueDepth.h"
#include "PreparedVolume.h"
#include "VolumePropertyReader.h"
#include "WindowPixels.h"
#include "vtkConvexCellMapper.h"
#include "vtkConvexCells.h"
#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"
#include "vtkWeakPointer.h"

#include <array>
#include <set>
#include <string>
#include <vector>

/// What decides the normalised scalars, their values and the cells apart.
struct ScalarSource
{
  const vtkDataArray* Array = nullptr;
  int Component = 0;
  std::array<double, 2> Limits{ { 0.0, 0.0 } };

  bool operator==(const ScalarSource& other) const
  {
    return this->Array == other.Array && this->Component == other.Component &&
           this->Limits == other.Limits;
  }
};

/// What vtkConvexCellMapper keeps from frame to frame.
class vtkConvexCellMapper::Internals
{
public:
  /// Takes what is new of the cells and their points. Scalars alone leave both as they are
  /// (vtkConvexCells), and all that was made from them. True where the cells are new.
  bool TakeGeometry(vtkUnstructuredGrid* convex)
  {
    vtkPoints* points = convex->GetPoints();
    const std::array<vtkMTimeType, 2> times = { { points ? points->GetMTime() : 0,
      points ? points->GetData()->GetMTime() : 0 } };
    const bool isNew = this->SeenCells != convex->GetCells()->GetMTime();
    if (isNew)
    {
      this->Prepared.TakeCells(convex);
    }
    else if (this->SeenPoints != times)
    {
      this->Prepared.TakePoints();
    }
    this->SeenCells = convex->GetCells()->GetMTime();
    this->SeenPoints = times;
    return isNew;
  }

  MapperInput Input;
  vtkUnstructuredGridBase* Mesh = nullptr; // the input of this frame
  vtkNew<vtkConvexCells> Cells;
  PreparedVolume Prepared;
  vtkMTimeType SeenCells = 0;
  std::array<vtkMTimeType, 2> SeenPoints{};
  // What the transfer function was read from: the rest of a property may change without it.
  VolumePropertyReader::Source SeenFunction;
  bool SeenPerLength = true;
  // What the scalars were built from.
  ScalarSource SeenSource;

  OpaqueDepth Depth;
  std::vector<float> OpaqueDepths;
  FloatTarget Target;
  WindowPixels Pixels;
  // Whether the last frame of Tiles had something opaque before or in it.
  bool HadOpaque = false;
  CoarseImage Coarse;
  ImageSampling Sampling;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;

  FrameStatistics Statistics;
  vtkNew<vtkTable> StatisticsTable;
  vtkSmartPointer<vtkImageData> Captured;
  std::set<std::string> Reported;
  // Whether this frame has reported progress.
  bool IsPreparing = false;
};

#endif
