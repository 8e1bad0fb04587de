#ifndef FaceOrderSort_h
#define FaceOrderSort_h

#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkVisibilitySort.h"

#include <map>
#include <vector>

/**
 * The order that the tests hold for right: one sign per shared face, then a topological sort, in
 * double. Exact for convex meshes of tetrahedra without cycles; back to front only.
 */
class FaceOrderSort : public vtkVisibilitySort
{
public:
  static FaceOrderSort* New();
  vtkTypeMacro(FaceOrderSort, vtkVisibilitySort);

  void InitTraversal() override;
  vtkIdTypeArray* GetNextCells() override;

  /// Cells that were left over because they hide each other in a circle: 0 proves the order.
  vtkIdType GetNumberOfUnorderedCells() const { return this->NumberOfUnorderedCells; }

protected:
  FaceOrderSort() = default;
  ~FaceOrderSort() override = default;

private:
  struct Face
  {
    vtkIdType Points[3];
    vtkIdType Cells[2];
  };
  void FindSharedFaces();
  void SortTopologically();
  bool FindNearer(const Face& face, vtkIdType& nearer, vtkIdType& farther);
  double SideOf(const Face& face, const double point[3], double w);

  vtkNew<vtkIdTypeArray> Order;
  std::vector<Face> Faces;
  double Eye[4] = { 0.0, 0.0, 0.0, 1.0 };
  vtkIdType NumberOfUnorderedCells = 0;
  bool Returned = false;
};

#endif
