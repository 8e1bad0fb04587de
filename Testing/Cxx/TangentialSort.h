#ifndef TangentialSort_h
#define TangentialSort_h

#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkVisibilitySort.h"

/**
 * Back to front by the squared tangential distance to the cells' circumspheres, in double: exact
 * for Delaunay meshes in perspective, with or without holes in them (Max, Hanrahan and Crawfis
 * 1990; Cignoni and De Floriani 1995). Perspective only.
 */
class TangentialSort : public vtkVisibilitySort
{
public:
  static TangentialSort* New();
  vtkTypeMacro(TangentialSort, vtkVisibilitySort);

  void InitTraversal() override;
  vtkIdTypeArray* GetNextCells() override;

protected:
  TangentialSort() = default;
  ~TangentialSort() override = default;

private:
  vtkNew<vtkIdTypeArray> Order;
  bool Returned = false;
};

#endif
