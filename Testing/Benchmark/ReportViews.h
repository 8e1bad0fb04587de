#ifndef ReportViews_h
#define ReportViews_h

#include "vtkSmartPointer.h"

#include <map>
#include <tuple>

class BenchmarkScene;
class vtkCellProjectionOracle;
class vtkRenderer;
class vtkUnstructuredGrid;

/// Three views of one mesh, the last from inside it, and what the float64 ray caster sees from each.
class ReportViews
{
public:
  static constexpr int Count = 3;
  static constexpr int Inside = Count - 1;

  /// The eye of the last view is in that tetrahedron which is next to the middle of the bounds.
  ReportViews(vtkUnstructuredGrid* tetrahedra, int size);

  /// To be called where the look has changed: the ray caster's images are kept.
  void Forget() { this->Images.clear(); }

  /// Places the eye; neither it nor the clipping range depends on what the renderer shows.
  void Look(int view, vtkRenderer* renderer) const;

  /// With the image of `cells` as the scene shows them from the view it looks from.
  vtkCellProjectionOracle* GetOracle(
    int view, int blendMode, vtkUnstructuredGrid* cells, BenchmarkScene& scene);

private:
  int Size;
  double Center[3];
  double Length;
  double Within[3];
  std::map<std::tuple<int, int, vtkUnstructuredGrid*>, vtkSmartPointer<vtkCellProjectionOracle>>
    Images;
};

#endif
