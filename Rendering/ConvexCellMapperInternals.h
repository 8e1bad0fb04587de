#ifndef ConvexCellMapperInternals_h
#define ConvexCellMapperInternals_h

#include "CellProjectionFrame.h"
#include "FloatTarget.h"
#include "OpaqueDepth.h"
#include "PreparedVolume.h"
#include "vtkConvexCellMapper.h"
#include "vtkConvexCells.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkWeakPointer.h"

#include <array>
#include <set>
#include <string>

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
  vtkNew<vtkConvexCells> Cells;
  PreparedVolume Prepared;
  vtkMTimeType SeenCells = 0;
  // What the transfer function was read from: another property may be older than the last one.
  const void* SeenProperty = nullptr;
  // What the scalars were built from.
  ScalarSource SeenSource;

  OpaqueDepth Depth;
  FloatTarget Target;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;

  FrameStatistics Statistics;
  vtkNew<vtkTable> StatisticsTable;
  vtkSmartPointer<vtkImageData> Captured;
  std::set<std::string> Reported;
};

#endif
