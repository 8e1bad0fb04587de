#ifndef vtkCellProjectionOracle_h
#define vtkCellProjectionOracle_h

#include "vtkCellProjectionOracleModule.h" // for export macro
#include "vtkObject.h"

class VTKCELLPROJECTIONORACLE_EXPORT vtkCellProjectionOracle : public vtkObject
{
public:
  static vtkCellProjectionOracle* New();
  vtkTypeMacro(vtkCellProjectionOracle, vtkObject);

protected:
  vtkCellProjectionOracle() = default;
  ~vtkCellProjectionOracle() override = default;

private:
  vtkCellProjectionOracle(const vtkCellProjectionOracle&) = delete;
  void operator=(const vtkCellProjectionOracle&) = delete;
};

#endif
