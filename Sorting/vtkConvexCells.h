#ifndef vtkConvexCells_h
#define vtkConvexCells_h

#include "vtkCellProjectionModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

class VTKCELLPROJECTION_EXPORT vtkConvexCells : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkConvexCells* New();
  vtkTypeMacro(vtkConvexCells, vtkUnstructuredGridAlgorithm);

protected:
  vtkConvexCells() = default;
  ~vtkConvexCells() override = default;

private:
  vtkConvexCells(const vtkConvexCells&) = delete;
  void operator=(const vtkConvexCells&) = delete;
};

#endif
