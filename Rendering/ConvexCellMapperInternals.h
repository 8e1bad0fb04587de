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

#include <set>
#include <string>

/// What vtkConvexCellMapper keeps from frame to frame.
class vtkConvexCellMapper::Internals
{
public:
  vtkNew<vtkConvexCells> Cells;
  PreparedVolume Prepared;
  vtkMTimeType SeenCells = 0;
  // What the transfer function was read from: another property may be older than the last one.
  const void* SeenProperty = nullptr;
  int SeenComponent = 0;

  OpaqueDepth Depth;
  FloatTarget Target;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;

  FrameStatistics Statistics;
  vtkNew<vtkTable> StatisticsTable;
  vtkSmartPointer<vtkImageData> Captured;
  std::set<std::string> Reported;
};

#endif
