#include "ReportLevels.h"

#include "vtkNew.h"
#include "vtkTetrahedraSimplifier.h"
#include "vtkUnstructuredGrid.h"

//------------------------------------------------------------------------------
const ReportLevels::Level& ReportLevels::Get(double percent)
{
  Level& level = this->Levels[percent];
  if (!level.Grid && percent == 0.0)
  {
    level.Grid = this->Tetrahedra;
  }
  else if (!level.Grid)
  {
    vtkNew<vtkTetrahedraSimplifier> simplifier;
    simplifier->SetInputData(this->Tetrahedra);
    simplifier->SetMaximumFieldError(percent / 100.0);
    simplifier->Update();
    level.Grid = simplifier->GetOutput();
    level.Seconds = simplifier->GetSeconds();
  }
  return level;
}
