/**
 * What the oracle's tests share: checks that say where they failed, boxes cut into any cell type,
 * and rays worked out from the camera's position, angle and scale instead of its matrices.
 */

#ifndef TestOracleScene_h
#define TestOracleScene_h

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkCellProjectionOracle.h"
#include "vtkCellType.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iomanip>
#include <iostream>
#include <limits>
#include <vector>

/** Counts failures; the first few are printed. */
class TestOracleChecks
{
public:
  void Near(double actual, double expected, double tolerance, const char* what, int line)
  {
    if (!(std::abs(actual - expected) <= tolerance))
    {
      this->Fail(what, line);
      std::cerr << std::setprecision(17) << "  " << actual << " where " << expected << " +- "
                << tolerance << " is right\n";
    }
  }
  void True(bool condition, const char* what, int line)
  {
    if (!condition)
    {
      this->Fail(what, line);
    }
  }
  int GetResult() const { return this->Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }
  explicit TestOracleChecks(const char* file)
    : File(file)
  {
  }

private:
  void Fail(const char* what, int line)
  {
    ++this->Failures;
    std::cerr << this->File << ":" << line << ": " << what << "\n";
    if (this->Failures == 20)
    {
      std::exit(EXIT_FAILURE);
    }
  }
  const char* File;
  int Failures = 0;
};

#define CHECK_NEAR(checks, actual, expected, tolerance) \
  (checks).Near(actual, expected, tolerance, #actual, __LINE__)
#define CHECK_TRUE(checks, condition) (checks).True(condition, #condition, __LINE__)

using TestOracleField = std::function<double(double x, double y, double z)>;

/** A box cut into blocks and each block into cells of one type, with the point scalars of a field.
 */
class TestOracleBox
{
public:
  std::array<double, 6> Bounds = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  std::array<int, 3> Blocks = { 3, 2, 2 };
  int CellType = VTK_HEXAHEDRON;
  TestOracleField Field = [](double, double, double) { return 0.5; };

  vtkSmartPointer<vtkUnstructuredGrid> Build() const
  {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    grid->SetPoints(points);
    vtkNew<vtkDoubleArray> scalars;
    scalars->SetName("scalars");
    grid->GetPointData()->SetScalars(scalars);
    for (int k = 0; k <= this->Blocks[2]; ++k)
    {
      for (int j = 0; j <= this->Blocks[1]; ++j)
      {
        for (int i = 0; i <= this->Blocks[0]; ++i)
        {
          this->AddPoint(grid, i, j, k);
        }
      }
    }
    for (int k = 0; k < this->Blocks[2]; ++k)
    {
      for (int j = 0; j < this->Blocks[1]; ++j)
      {
        for (int i = 0; i < this->Blocks[0]; ++i)
        {
          this->AddBlock(grid, i, j, k);
        }
      }
    }
    return grid;
  }

private:
  vtkIdType AddPoint(vtkUnstructuredGrid* grid, double i, double j, double k) const
  {
    const double index[3] = { i, j, k };
    double p[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double share = index[axis] / this->Blocks[axis];
      p[axis] = this->Bounds[2 * axis] * (1.0 - share) + this->Bounds[2 * axis + 1] * share;
    }
    vtkDoubleArray::SafeDownCast(grid->GetPointData()->GetScalars())
      ->InsertNextValue(this->Field(p[0], p[1], p[2]));
    return grid->GetPoints()->InsertNextPoint(p);
  }

  void AddBlock(vtkUnstructuredGrid* grid, int i, int j, int k) const
  {
    vtkIdType c[8]; // in the order of a voxel
    for (int corner = 0; corner < 8; ++corner)
    {
      const int x = i + (corner & 1), y = j + (corner >> 1 & 1), z = k + (corner >> 2);
      c[corner] = x + (this->Blocks[0] + 1) * (y + (this->Blocks[1] + 1) * vtkIdType(z));
    }
    std::vector<std::vector<vtkIdType>> cells;
    switch (this->CellType)
    {
      case VTK_TETRA:
        // The six paths along the axes from the first to the last corner: conforming everywhere.
        cells = { { c[0], c[1], c[3], c[7] }, { c[0], c[1], c[5], c[7] },
          { c[0], c[2], c[3], c[7] }, { c[0], c[2], c[6], c[7] }, { c[0], c[4], c[5], c[7] },
          { c[0], c[4], c[6], c[7] } };
        break;
      case VTK_WEDGE:
        cells = { { c[0], c[1], c[3], c[4], c[5], c[7] }, { c[0], c[3], c[2], c[4], c[7], c[6] } };
        break;
      case VTK_PYRAMID:
      {
        const vtkIdType m = this->AddPoint(grid, i + 0.5, j + 0.5, k + 0.5);
        cells = { { c[0], c[1], c[3], c[2], m }, { c[4], c[5], c[7], c[6], m },
          { c[0], c[1], c[5], c[4], m }, { c[2], c[3], c[7], c[6], m },
          { c[0], c[2], c[6], c[4], m }, { c[1], c[3], c[7], c[5], m } };
        break;
      }
      case VTK_HEXAHEDRON:
        cells = { { c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6] } };
        break;
      case VTK_POLYHEDRON:
        cells = { { 6, 4, c[0], c[1], c[3], c[2], 4, c[4], c[5], c[7], c[6], 4, c[0], c[1], c[5],
          c[4], 4, c[2], c[3], c[7], c[6], 4, c[0], c[2], c[6], c[4], 4, c[1], c[3], c[7], c[5] } };
        break;
      default:
        cells = { { c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7] } };
    }
    for (const std::vector<vtkIdType>& cell : cells)
    {
      vtkNew<vtkIdList> ids;
      for (vtkIdType id : cell)
      {
        ids->InsertNextId(id);
      }
      grid->InsertNextCell(this->CellType, ids);
    }
  }
};

/** An oracle with a volume, a camera and constant functions, which a test replaces as it needs. */
class TestOracleScene
{
public:
  vtkNew<vtkCellProjectionOracle> Oracle;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkPiecewiseFunction> Opacity;
  std::array<double, 3> Kappa = { 0.2, 0.5, 0.9 };
  int Width = 24;
  int Height = 18;

  TestOracleScene()
  {
    this->Color->AddRGBPoint(0.0, this->Kappa[0], this->Kappa[1], this->Kappa[2]);
    this->SetExtinction(0.8);
    this->Volume->GetProperty()->SetColor(this->Color);
    this->Volume->GetProperty()->SetScalarOpacity(this->Opacity);
    this->Camera->SetPosition(1.1, 0.7, 4.0);
    this->Camera->SetFocalPoint(0.1, 0.0, 0.0);
    this->Camera->SetClippingRange(0.1, 100.0);
    this->Camera->SetParallelScale(1.6);
    this->Oracle->SetVolume(this->Volume);
    this->Oracle->SetCamera(this->Camera);
    this->Oracle->SetSize(this->Width, this->Height);
  }

  /** Opacity one and the unit distance do it: an extinction may exceed one. */
  void SetExtinction(double extinction)
  {
    this->Opacity->RemoveAllPoints();
    this->Opacity->AddPoint(0.0, 1.0);
    this->Volume->GetProperty()->SetScalarOpacityUnitDistance(1.0 / extinction);
  }

  bool Draw(vtkUnstructuredGrid* grid)
  {
    this->Oracle->SetInputData(grid);
    return this->Oracle->Update();
  }

  double GetValue(int column, int row, int component) const
  {
    return this->Oracle->GetImage()->GetScalarComponentAsDouble(column, row, 0, component);
  }

  /** A pixel's ray: its start on the eye's plane, its unit direction and its cosine with the axis.
   */
  void GetRay(int column, int row, double start[3], double direction[3], double& cosine) const
  {
    double forward[3], right[3], up[3];
    vtkMath::Subtract(this->Camera->GetFocalPoint(), this->Camera->GetPosition(), forward);
    vtkMath::Normalize(forward);
    vtkMath::Cross(forward, this->Camera->GetViewUp(), right);
    vtkMath::Normalize(right);
    vtkMath::Cross(right, forward, up);
    const double half = vtkMath::RadiansFromDegrees(this->Camera->GetViewAngle() / 2.0);
    const bool parallel = this->Camera->GetParallelProjection() != 0;
    const double scale = parallel ? this->Camera->GetParallelScale() : std::tan(half);
    const double y = scale * (2.0 * (row + 0.5) / this->Height - 1.0);
    const double x =
      scale * (2.0 * (column + 0.5) / this->Width - 1.0) * this->Width / this->Height;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double offset = x * right[axis] + y * up[axis];
      start[axis] = this->Camera->GetPosition()[axis] + (parallel ? offset : 0.0);
      direction[axis] = forward[axis] + (parallel ? 0.0 : offset);
    }
    vtkMath::Normalize(direction);
    cosine = vtkMath::Dot(direction, forward);
  }

  /** Where a pixel's ray is inside the volume's box, in world length; first >= second: nowhere. */
  std::array<double, 2> GetInterval(int column, int row, const std::array<double, 6>& bounds) const
  {
    double start[4] = { 0.0, 0.0, 0.0, 1.0 }, direction[4] = { 0.0, 0.0, 0.0, 0.0 }, cosine;
    this->GetRay(column, row, start, direction, cosine);
    vtkNew<vtkMatrix4x4> worldToData;
    vtkMatrix4x4::Invert(this->Volume->GetMatrix(), worldToData);
    worldToData->MultiplyPoint(start, start);
    worldToData->MultiplyPoint(direction, direction);
    double near = this->Camera->GetClippingRange()[0] / cosine;
    double far = this->Camera->GetClippingRange()[1] / cosine;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double a = (bounds[2 * axis] - start[axis]) / direction[axis];
      const double b = (bounds[2 * axis + 1] - start[axis]) / direction[axis];
      near = std::max(near, std::min(a, b));
      far = std::min(far, std::max(a, b));
    }
    return { near, std::max(near, far) };
  }
};

#endif
