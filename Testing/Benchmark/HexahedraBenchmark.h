#ifndef HexahedraBenchmark_h
#define HexahedraBenchmark_h

#include "BenchmarkScene.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

class vtkCellProjectionOracle;
class vtkConvexCellMapper;
class vtkUnstructuredGrid;
class vtkUnstructuredGridVolumeMapper;

/**
 * The mappers that draw hexahedra as they are, ours on the same mesh cut into tetrahedra, and VTK's
 * projected tetrahedra: same views and transfer functions, frames interleaved, each one's error
 * against the float64 oracle of its own blend mode in its row. Then what dropping transparent cells
 * saves.
 */
class HexahedraBenchmark
{
public:
  HexahedraBenchmark(const std::string& name, vtkUnstructuredGrid* hexahedra);

  /// Medians of `frames`, at least 9.
  void Run(int frames);

private:
  struct Row
  {
    std::string Name;
    vtkSmartPointer<vtkUnstructuredGridVolumeMapper> Mapper;
    bool IsCut;
    /// Opacity below 45 % of the scalar's range; negative leaves the function as it is.
    double Low = -1.0;
    std::unique_ptr<BenchmarkScene> Scene;
    double First = 0.0;
    double Prepare = 0.0;
    std::vector<double> Seconds;
    double RootMeanSquare = 0.0;
    double Percentile = 0.0;
    double Maximum = 0.0;
  };

  void AddRow(const std::string& name, vtkUnstructuredGridVolumeMapper* mapper, double low = -1.0);
  void AddRows();
  std::unique_ptr<BenchmarkScene> MakeScene(const Row& row, int size);
  void MeasureSpeed(int frames);
  void MeasureError(Row& row);
  vtkSmartPointer<vtkCellProjectionOracle> GetOracle(const Row& row, BenchmarkScene& scene);
  void Print();
  double SecondsOf(const std::string& name) const;

  std::string Name;
  vtkSmartPointer<vtkUnstructuredGrid> Hexahedra;
  vtkSmartPointer<vtkUnstructuredGrid> Convex;
  vtkSmartPointer<vtkUnstructuredGrid> Tetrahedra;
  std::vector<Row> Rows;
  /// The oracle drew last for this kind of row.
  std::string OracleKind;
  vtkSmartPointer<vtkCellProjectionOracle> Oracle;
};

#endif
