#include "ReportScene.h"

#include "BenchmarkScene.h"
#include "CellComplexReader.h"
#include "OrderProof.h"
#include "ViewEye.h"

#include "vtkCellProjectionOracle.h"
#include "vtkCommand.h"
#include "vtkConvexCellMapper.h"
#include "vtkConvexCells.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPreIntegratedTetrahedraMapper.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"
#include "vtkVisibilitySort.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>

namespace
{
/// What a mapper says, instead of printing it.
class Listener : public vtkCommand
{
public:
  static Listener* New() { return new Listener; }
  void Execute(vtkObject*, unsigned long, void* data) override
  {
    this->Text += data ? static_cast<const char*>(data) : "";
  }

  std::string Text;
};

/// Aborts a frame that takes too long; VTK's mappers ask for that.
class FrameLimit : public vtkCommand
{
public:
  static FrameLimit* New() { return new FrameLimit; }
  void Watch(vtkRenderWindow* window, double seconds)
  {
    this->Seconds = seconds;
    window->AddObserver(vtkCommand::StartEvent, this);
    window->AddObserver(vtkCommand::AbortCheckEvent, this);
  }
  void Execute(vtkObject* window, unsigned long event, void*) override
  {
    const auto now = std::chrono::steady_clock::now();
    if (event == vtkCommand::StartEvent)
    {
      this->Start = now;
    }
    else if (std::chrono::duration<double>(now - this->Start).count() > this->Seconds)
    {
      this->WasExceeded = true;
      vtkRenderWindow::SafeDownCast(window)->SetAbortRender(1);
    }
  }

  bool WasExceeded = false;

private:
  double Seconds = 0.0;
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

vtkVariant Statistic(vtkUnstructuredGridVolumeMapper* mapper, const char* column)
{
  auto* ours = vtkConvexCellMapper::SafeDownCast(mapper);
  return ours ? ours->GetLastStatistics()->GetValueByName(0, column) : vtkVariant(0);
}

/// VTK's ray casters warn without end, and through no object that could be asked.
class Silence
{
public:
  explicit Silence(bool isWanted)
  {
    vtkObject::SetGlobalWarningDisplay(isWanted ? 0 : this->Display);
  }
  ~Silence() { vtkObject::SetGlobalWarningDisplay(this->Display); }
  Silence(const Silence&) = delete;
  void operator=(const Silence&) = delete;

private:
  const int Display = vtkObject::GetGlobalWarningDisplay();
};

const char* BlendName(int mode)
{
  return mode == vtkConvexCellMapper::ADDITIVE ? "additive"
    : mode == vtkConvexCellMapper::COMPOSITE   ? "composite"
                                               : "maximum";
}

// VTK's window shows colours alone: the oracle's own alpha keeps alpha out of the comparison.
vtkSmartPointer<vtkImageData> CaptureWindow(BenchmarkScene& scene, vtkImageData* oracle)
{
  auto image = scene.ReadWindow();
  vtkDataArray* alpha = oracle->GetPointData()->GetScalars();
  for (vtkIdType pixel = 0; pixel < image->GetNumberOfPoints(); ++pixel)
  {
    image->GetPointData()->GetScalars()->SetComponent(pixel, 3, alpha->GetComponent(pixel, 3));
  }
  return image;
}
}

//------------------------------------------------------------------------------
ReportScene::ReportScene(const ReportMeshes::Mesh& mesh, const Settings& settings)
  : With(settings)
  , Name(mesh.Name)
  , Whole(mesh.Grid)
  , Tetrahedra(CutToTetrahedra(mesh.Grid))
{
  vtkNew<vtkConvexCells> convex;
  convex->SetInputData(mesh.Grid);
  convex->Update();
  this->Convex = convex->GetOutput();
  CellComplexReader::Read(this->Tetrahedra, this->Complex);
}

//------------------------------------------------------------------------------
void ReportScene::SetLook(const std::string& transfer, const std::string& light)
{
  // VTK has no lit tetrahedra: the unlit ones of the same function stay what lit rows compare with.
  this->Reference = transfer == this->Transfer ? this->Reference : 0.0;
  this->Transfer = transfer;
  this->Light = light;
  this->Oracles.clear();
  this->ShirleyTuchman = nullptr;
}

//------------------------------------------------------------------------------
vtkUnstructuredGrid* ReportScene::GetInput(const ReportMethods::Method& method)
{
  return method.NeedsTetrahedra ? this->Tetrahedra : this->Whole;
}

//------------------------------------------------------------------------------
void ReportScene::SetProperty(BenchmarkScene& scene)
{
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  property->SetShade(this->Light == "lit");
  property->SetAmbient(0.3);
  property->SetDiffuse(0.6);
  property->SetSpecular(0.3);
  property->SetSpecularPower(20.0);
  if (this->Transfer == "spiky")
  {
    double range[2];
    this->Whole->GetScalarRange(range);
    vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
    opacity->RemoveAllPoints();
    for (int i = 0; i < 9; ++i)
    {
      const double spike = i % 2 == 0 ? 0.0 : 0.4 + 0.3 * (i % 3);
      opacity->AddPoint(range[0] + i / 8.0 * (range[1] - range[0]), spike);
    }
    property->SetScalarOpacityUnitDistance(this->Whole->GetLength() / 60.0);
  }
}

//------------------------------------------------------------------------------
bool ReportScene::IsDrawn(const ReportMethods::Method& method,
  vtkUnstructuredGridVolumeMapper* mapper, const std::string& warnings)
{
  auto* ours = vtkConvexCellMapper::SafeDownCast(mapper);
  if (!ours)
  {
    return true;
  }
  std::string lower(warnings);
  std::transform(lower.begin(), lower.end(), lower.begin(), ::tolower);
  const bool isUnlit = lower.find("shad") != std::string::npos;
  return ours->GetCapturedImage() && Statistic(mapper, "Engine").ToString() == method.Engine &&
    !(this->Light == "lit" && isUnlit);
}

//------------------------------------------------------------------------------
vtkCellProjectionOracle* ReportScene::GetOracle(
  const ReportMethods::Method& method, int blendMode, BenchmarkScene& scene)
{
  vtkSmartPointer<vtkCellProjectionOracle>& oracle =
    this->Oracles[BlendName(blendMode) + std::string(method.NeedsTetrahedra ? " cut" : "")];
  if (!oracle)
  {
    oracle = vtkSmartPointer<vtkCellProjectionOracle>::New();
    oracle->SetInputData(method.NeedsTetrahedra ? this->Tetrahedra : this->Convex);
    oracle->SetVolume(scene.Volume);
    oracle->SetCamera(scene.Renderer->GetActiveCamera());
    oracle->SetSize(this->With.ErrorSize, this->With.ErrorSize);
    oracle->SetBlendMode(blendMode);
    oracle->Update();
  }
  return oracle;
}

//------------------------------------------------------------------------------
long long ReportScene::CountMisordered(vtkVisibilitySort* sort, BenchmarkScene& scene)
{
  std::vector<vtkIdType> order;
  sort->InitTraversal();
  while (vtkIdTypeArray* batch = sort->GetNextCells())
  {
    const vtkIdType* ids = batch->GetPointer(0);
    order.insert(order.end(), ids, ids + batch->GetNumberOfValues());
  }
  vtkNew<vtkMatrix4x4> identity;
  double eye[4];
  ViewEye::Find(scene.Renderer->GetActiveCamera(), identity, eye);
  return OrderProof::CountMisordered(this->Complex, order, eye);
}

//------------------------------------------------------------------------------
long long ReportScene::CountMisordered(
  vtkUnstructuredGridVolumeMapper* mapper, BenchmarkScene& scene)
{
  if (auto* theirs = vtkProjectedTetrahedraMapper::SafeDownCast(mapper))
  {
    return this->CountMisordered(theirs->GetVisibilitySort(), scene);
  }
  auto* ours = vtkPreIntegratedTetrahedraMapper::SafeDownCast(mapper);
  if (ours && ours->GetVisibilitySort())
  {
    return this->CountMisordered(ours->GetVisibilitySort(), scene);
  }
  return ours ? Statistic(mapper, "MisorderedFaces").ToLongLong() : -1;
}

//------------------------------------------------------------------------------
void ReportScene::CompareWithShirleyTuchman(
  const ReportMethods::Method& method, vtkImageData* image, ReportRow& row)
{
  if (method.Curve == ReportMethods::ShirleyTuchman)
  {
    this->ShirleyTuchman = vtkSmartPointer<vtkImageData>::New();
    this->ShirleyTuchman->DeepCopy(image);
  }
  if (!this->ShirleyTuchman || !method.IsApproximation)
  {
    return;
  }
  vtkDataArray* theirs = this->ShirleyTuchman->GetPointData()->GetScalars();
  vtkDataArray* ours = image->GetPointData()->GetScalars();
  double sum = 0.0;
  int covered = 0;
  for (vtkIdType pixel = 0; pixel < image->GetNumberOfPoints(); ++pixel)
  {
    const bool isCovered =
      theirs->GetComponent(pixel, 3) > 0.0 || ours->GetComponent(pixel, 3) > 0.0;
    covered += isCovered ? 1 : 0;
    for (int i = 0; i < 3; ++i)
    {
      sum += std::abs(theirs->GetComponent(pixel, i) - ours->GetComponent(pixel, i)) / 3.0;
    }
  }
  row.ToShirleyTuchman = covered > 0 ? 255.0 * sum / covered : 0.0;
}

//------------------------------------------------------------------------------
bool ReportScene::MeasureError(const ReportMethods::Method& method, ReportRow& row)
{
  const Mapper mapper = method.Make();
  if (this->Light == "lit" && !vtkConvexCellMapper::SafeDownCast(mapper))
  {
    return false;
  }
  vtkNew<Listener> listener;
  mapper->AddObserver(vtkCommand::WarningEvent, listener);
  if (auto* ours = vtkConvexCellMapper::SafeDownCast(mapper))
  {
    ours->CaptureImageOn();
  }
  if (auto* ours = vtkPreIntegratedTetrahedraMapper::SafeDownCast(mapper))
  {
    ours->ReportOrderOn();
  }
  BenchmarkScene scene(mapper, this->GetInput(method), this->With.ErrorSize);
  this->SetProperty(scene);
  vtkNew<FrameLimit> limit;
  limit->Watch(scene.Window, this->With.SecondsPerFrame);
  // Of the first frame of VTK's projected tetrahedra a part is missing.
  scene.TimeFrame(0);
  if (limit->WasExceeded)
  {
    return this->GiveUp(method);
  }
  scene.TimeFrame(0);
  if (!this->IsDrawn(method, mapper, listener->Text))
  {
    return false;
  }
  vtkCellProjectionOracle* oracle = this->GetOracle(method, mapper->GetBlendMode(), scene);
  auto* ours = vtkConvexCellMapper::SafeDownCast(mapper);
  const vtkSmartPointer<vtkImageData> image =
    ours ? ours->GetCapturedImage() : CaptureWindow(scene, oracle->GetImage()).GetPointer();
  oracle->Compare(image);
  row.RootMeanSquare = oracle->GetRootMeanSquareError();
  row.Percentile = oracle->GetPercentileError();
  row.Maximum = oracle->GetMaximumError();
  row.Share = oracle->GetShareAboveHalfLevel();
  row.MisorderedFaces = this->CountMisordered(mapper, scene);
  row.Blend = BlendName(mapper->GetBlendMode());
  this->CompareWithShirleyTuchman(method, image, row);
  return true;
}

//------------------------------------------------------------------------------
bool ReportScene::MeasureSpeed(
  const ReportMethods::Method& method, double seconds, ReportRow& row)
{
  const Mapper mapper = method.Make();
  // What it has to say was heard when its error was measured.
  vtkNew<Listener> listener;
  mapper->AddObserver(vtkCommand::WarningEvent, listener);
  BenchmarkScene scene(mapper, this->GetInput(method), this->With.ImageSize);
  this->SetProperty(scene);
  vtkNew<FrameLimit> limit;
  limit->Watch(scene.Window, this->With.SecondsPerFrame);
  row.First = scene.TimeFrame(0);
  row.Prepare = Statistic(mapper, "SecondsPrepare").ToDouble();
  double spent = row.First;
  for (int frame = 1; frame <= this->With.Frames && !limit->WasExceeded; ++frame)
  {
    if (frame > this->With.LeastFrames && spent > seconds)
    {
      break;
    }
    row.Frames.push_back(scene.TimeFrame(frame));
    spent += row.Frames.back();
  }
  return !limit->WasExceeded || this->GiveUp(method);
}

//------------------------------------------------------------------------------
bool ReportScene::GiveUp(const ReportMethods::Method& method)
{
  this->GivenUp.insert(method.Curve);
  std::cout << "given up: " << method.Curve << " on " << this->Name << ", where a frame takes more than " << this->With.SecondsPerFrame << " s" << std::endl;
  return false;
}

//------------------------------------------------------------------------------
bool ReportScene::Measure(
  const ReportMethods::Method& method, double seconds, ReportRow& row)
{
  if (this->GivenUp.count(method.Curve) > 0)
  {
    return false;
  }
  const Silence silence(method.Engine == "CPU");
  if (!this->MeasureError(method, row) || !this->MeasureSpeed(method, seconds, row))
  {
    return false;
  }
  if (method.Curve == ReportMethods::Reference && this->Reference == 0.0)
  {
    this->Reference = Median(row.Frames);
  }
  row.Scene = this->Name;
  row.Cells = this->GetInput(method)->GetNumberOfCells();
  row.Transfer = this->Transfer;
  row.Light = this->Light;
  row.Curve = method.Curve;
  row.Setting = method.Setting;
  row.Engine = method.Engine;
  row.Sort = method.Sort;
  row.Reference = this->Reference;
  return true;
}
