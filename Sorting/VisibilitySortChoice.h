/**
 * Which sort to use for a mesh; the sort it names is made once and kept between frames.
 *
 * Automatic: the power sort where it is proven exact for every eye (a convex Delaunay mesh, see
 * vtkPowerVisibilitySort::IsExact), else MPVO. The question is asked once per mesh; moving eyes and
 * new scalars do not raise it again. Without convexification nothing is proven, and MPVO is taken.
 */
#ifndef VisibilitySortChoice_h
#define VisibilitySortChoice_h

#include "MeshTime.h"
#include "vtkPowerVisibilitySort.h"

#include "vtkSmartPointer.h"

class VisibilitySortChoice
{
public:
  enum Method
  {
    Automatic,
    MPVO,
    MPVOC,
    Power,
    CellCenter
  };

  /** The sort, with input and camera set; `convexify` goes to sorts that have it. The input must
   *  not be null. */
  vtkVisibilitySort* Choose(int method, vtkDataSet* input, vtkCamera* camera, bool convexify);

  /** The sort that was chosen last; null before. */
  vtkVisibilitySort* GetSort() const { return this->Sort; }
  /** The same where it proves its order, else null. */
  vtkProvenVisibilitySort* GetProvenSort() const;
  /** "MPVO", "MPVOC", "Power" or "CellCenter": what was chosen last; empty before. */
  const char* GetName() const { return this->Name; }

private:
  int Resolve(int method, vtkDataSet* input, bool convexify);
  void Make(int method);

  vtkSmartPointer<vtkVisibilitySort> Sort;
  int Made = Automatic; // the kind of Sort; Automatic: none yet
  const char* Name = "";

  vtkSmartPointer<vtkPowerVisibilitySort> ExactPower;
  // Until the sort that is taken instead has its adjacency.
  vtkSmartPointer<vtkPowerVisibilitySort> InexactPower;
  vtkDataSet* SeenInput = nullptr; // compared only
  MeshTime SeenTime{};
};

#endif
