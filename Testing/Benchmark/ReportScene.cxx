#include "ReportScene.h"

#include "BenchmarkScene.h"
#include "CellComplexReader.h"
#include "FrameLimit.h"
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
  , Views(this->Tetrahedra, settings.ErrorSize)
  , Levels(this->Tetrahedra)
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
  this->Views.Forget();
  this->ShirleyTuchman = nullptr;
}

//------------------------------------------------------------------------------
vtkUnstructuredGrid* ReportScene::GetInput(const ReportMethods::Method& method)
{
  return method.NeedsTetrahedra ? this->Levels.Get(method.Simplified).Grid.GetPointer()
                                : this->Whole.GetPointer();
}

//------------------------------------------------------------------------------
void ReportScene::SetProperty(BenchmarkScene& scene)
{
  scene.SetFunctionsFor(this->Whole);
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
long long ReportScene::CountMisordered(const ReportMethods::Method& method,
  vtkUnstructuredGridVolumeMapper* mapper, BenchmarkScene& scene)
{
  if (auto* theirs = vtkProjectedTetrahedraMapper::SafeDownCast(mapper))
  {
    return this->CountMisordered(theirs->GetVisibilitySort(), scene);
  }
  auto* ours = vtkPreIntegratedTetrahedraMapper::SafeDownCast(mapper);
  if (ours && ours->GetVisibilitySort() && method.Simplified == 0.0)
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
  const int views = method.EndsInside ? ReportViews::Count : ReportViews::Inside;
  for (int view = 0; view < views && !limit->WasExceeded; ++view)
  {
    this->Views.Look(view, scene.Renderer);
    scene.Window->Render();
    if (!limit->WasExceeded && !this->IsDrawn(method, mapper, listener->Text))
    {
      return false;
    }
    this->CompareView(view, method, mapper, scene, row);
  }
  row.Blend = BlendName(mapper->GetBlendMode());
  return !limit->WasExceeded || this->GiveUp(method);
}

//------------------------------------------------------------------------------
void ReportScene::CompareView(int view, const ReportMethods::Method& method,
  vtkUnstructuredGridVolumeMapper* mapper, BenchmarkScene& scene, ReportRow& row)
{
  vtkCellProjectionOracle* oracle = this->Views.GetOracle(view, mapper->GetBlendMode(),
    method.NeedsTetrahedra ? this->Tetrahedra : this->Convex, scene);
  auto* ours = vtkConvexCellMapper::SafeDownCast(mapper);
  const vtkSmartPointer<vtkImageData> image =
    ours ? ours->GetCapturedImage() : CaptureWindow(scene, oracle->GetImage()).GetPointer();
  oracle->Compare(image);
  row.Errors.Add(oracle, view == ReportViews::Inside);
  row.MisorderedFaces =
    std::max(row.MisorderedFaces, this->CountMisordered(method, mapper, scene));
  if (view == 0)
  {
    this->CompareWithShirleyTuchman(method, image, row);
  }
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
  row.Prepare = Statistic(mapper, "SecondsPrepare").ToDouble() +
    (method.NeedsTetrahedra ? this->Levels.Get(method.Simplified).Seconds : 0.0);
  double spent = row.First;
  const int least = method.Engine == "CPU" ? this->With.LeastFrames : this->With.Frames;
  for (int frame = 1; frame <= this->With.Frames && !limit->WasExceeded; ++frame)
  {
    if (frame > least && spent > seconds)
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
  std::cout << "given up: " << method.Curve << " on " << this->Name
            << ", where a frame takes more than " << this->With.SecondsPerFrame << " s" << std::endl;
  return false;
}

//------------------------------------------------------------------------------
bool ReportScene::Measure(
  const ReportMethods::Method& method, double seconds, ReportRow& row)
{
  // What a sort costs and gets wrong is the same in any light.
  const bool isOfSort = method.Sort == "MPVO" || method.Sort == "Power" || method.Sort == "CellCenter";
  if (this->GivenUp.count(method.Curve) > 0 || (this->Light == "lit" && isOfSort))
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
