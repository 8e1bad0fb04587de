#include "PolyhedraScene.h"

#include "PolyhedraMeshes.h"

#include "vtkMaximumProjectionMapper.h"
#include "vtkPointData.h"
#include "vtkProjectedPolyhedraMapper.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{
constexpr double SilhouetteWidth = 1.0 / 64.0; // pixels
// An extremum's change over that width that no smooth field of a test has.
constexpr double Jump = 0.01;

using Value = std::array<double, 4>;

Value At(vtkImageData* image, vtkIdType pixel)
{
  Value value;
  image->GetPointData()->GetScalars()->GetTuple(pixel, value.data());
  return value;
}

double Distance(const Value& a, const Value& b)
{
  double largest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    const double difference = std::abs(a[i] - b[i]);
    // What is not a number is far from everything.
    largest = difference <= largest    ? largest
              : std::isnan(difference) ? std::numeric_limits<double>::infinity()
                                       : difference;
  }
  return largest;
}

double LargestDistance(vtkImageData* a, vtkImageData* b)
{
  double largest = 0.0;
  for (vtkIdType pixel = 0; pixel < a->GetNumberOfPoints(); ++pixel)
  {
    largest = std::max(largest, Distance(At(a, pixel), At(b, pixel)));
  }
  return largest;
}

bool IsNothing(const Value& value)
{
  return Distance(value, Value{}) == 0.0;
}

vtkSmartPointer<vtkConvexCellMapper> MakePolyhedra(int passes)
{
  auto mapper = vtkSmartPointer<vtkProjectedPolyhedraMapper>::New();
  mapper->SetPasses(passes);
  return mapper;
}

vtkSmartPointer<vtkConvexCellMapper> MakeExtremum(int mode)
{
  auto mapper = vtkSmartPointer<vtkMaximumProjectionMapper>::New();
  mapper->SetBlendMode(mode);
  return mapper;
}
}

//------------------------------------------------------------------------------
const std::vector<PolyhedraMappers::Entry>& PolyhedraMappers::All()
{
  static const std::vector<Entry> all = {
    { "one pass", [] { return MakePolyhedra(vtkProjectedPolyhedraMapper::ONE); }, false },
    { "three passes", [] { return MakePolyhedra(vtkProjectedPolyhedraMapper::THREE); }, true },
    { "maximum", [] { return MakeExtremum(vtkConvexCellMapper::MAXIMUM_INTENSITY); }, false },
    { "minimum", [] { return MakeExtremum(vtkConvexCellMapper::MINIMUM_INTENSITY); }, false },
  };
  return all;
}

//------------------------------------------------------------------------------
std::vector<PolyhedraMappers::Entry> PolyhedraMappers::Exact()
{
  std::vector<Entry> exact;
  std::copy_if(All().begin(), All().end(), std::back_inserter(exact),
    [](const Entry& entry) { return !entry.ThreePasses; });
  return exact;
}

//------------------------------------------------------------------------------
PolyhedraScene::PolyhedraScene(vtkConvexCellMapper* mapper, int width, int height)
  : TestScene(mapper, width, height)
{
  auto* polyhedra = vtkProjectedPolyhedraMapper::SafeDownCast(mapper);
  // Tiles asked for what they do not draw would say so.
  if (!polyhedra || polyhedra->GetPasses() == vtkProjectedPolyhedraMapper::ONE)
  {
    this->TakeTestEngine();
  }
  this->SetFunctions();
}

//------------------------------------------------------------------------------
bool PolyhedraScene::IsAdditive() const
{
  return this->Mapper->GetBlendMode() == vtkConvexCellMapper::ADDITIVE;
}

//------------------------------------------------------------------------------
double PolyhedraScene::GetBound() const
{
  return this->IsAdditive() ? 1e-4 : 1e-5;
}

//------------------------------------------------------------------------------
void PolyhedraScene::CheckWithOracle(TestChecks& checks, const std::string& name, int line)
{
  const Errors errors = this->CompareWithOracle(name);
  const bool good = errors.Compared >= 0.0 && errors.Compared <= this->GetBound();
  checks.Check(good, name.c_str(), line, std::to_string(errors.Compared));
  checks.Check(errors.SilhouettePixels <= 0.025 * errors.CoveredPixels,
    "few pixels are near silhouettes", line, std::to_string(errors.SilhouettePixels));
}

//------------------------------------------------------------------------------
void PolyhedraScene::SetFunctions()
{
  this->SetSmooth();
  if (!this->IsAdditive())
  {
    this->Color->RemoveAllPoints();
    this->Color->AddRGBPoint(0.0, 0.0, 1.0, 1.0);
    this->Color->AddRGBPoint(1.0, 1.0, 1.0, 0.0);
    this->Opacity->RemoveAllPoints();
    this->Opacity->AddPoint(0.0, 1.0);
  }
}

//------------------------------------------------------------------------------
void PolyhedraScene::CheckMostPixels(TestChecks& checks, const std::string& name, int line)
{
  const Errors errors = this->CompareWithOracle(name);
  const bool good = errors.Compared >= 0.0 && errors.WrongPixels <= 0.002 * errors.CoveredPixels;
  checks.Check(good, name.c_str(), line,
    std::to_string(errors.WrongPixels) + " pixels, by up to " + std::to_string(errors.Compared));
}

//------------------------------------------------------------------------------
void PolyhedraScene::SetLinearEmission()
{
  this->Color->RemoveAllPoints();
  this->Color->AddRGBPoint(0.0, 0.9, 0.5, 0.2);
  this->Opacity->RemoveAllPoints();
  this->Opacity->AddPoint(0.0, 0.2);
  this->Opacity->AddPoint(1.0, 1.8);
}

//------------------------------------------------------------------------------
void PolyhedraScene::SetMesh(vtkUnstructuredGrid* grid)
{
  this->Mapper->SetInputData(grid);
  this->Oracle->SetInputData(PolyhedraMeshes::Convex(grid));
}

//------------------------------------------------------------------------------
int PolyhedraScene::CountLitPixels()
{
  vtkImageData* image = this->Mapper->GetCapturedImage();
  int lit = 0;
  for (vtkIdType pixel = 0; image && pixel < image->GetNumberOfPoints(); ++pixel)
  {
    lit += IsNothing(At(image, pixel)) ? 0 : 1;
  }
  return lit;
}

//------------------------------------------------------------------------------
void PolyhedraScene::SetView(int view)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetParallelProjection(view == 1);
  camera->SetParallelScale(0.7);
  camera->SetViewAngle(view < 2 ? 30.0 : 60.0);
  if (view < 2)
  {
    const double eyes[2][3] = { { 0.5, 0.8, 1.8 }, { -1.9, 0.3, -0.9 } };
    this->LookFrom(eyes[view][0], eyes[view][1], eyes[view][2]);
    return;
  }
  camera->SetPosition(0.203, 0.302, 0.107);
  camera->SetFocalPoint(-0.4, -0.2, -0.1);
  camera->SetClippingRange(0.001, 20.0);
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkImageData>> PolyhedraScene::ImagesBeside()
{
  std::vector<vtkSmartPointer<vtkImageData>> images;
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const int* size = this->Renderer->GetSize();
  // All four are that far from the pixel's centre; they enclose it.
  const double step = SilhouetteWidth * std::sqrt(0.5);
  const double shifts[4][2] = { { step, step }, { -step, step }, { step, -step },
    { -step, -step } };
  for (const auto& shift : shifts)
  {
    camera->SetWindowCenter(2.0 * shift[0] / size[0], 2.0 * shift[1] / size[1]);
    images.emplace_back(this->UpdateOracle() ? this->Oracle->GetImage() : nullptr);
  }
  camera->SetWindowCenter(0.0, 0.0);
  return images;
}

//------------------------------------------------------------------------------
PolyhedraScene::Errors PolyhedraScene::CompareWithOracle(const std::string& name)
{
  this->Render();
  vtkImageData* captured = this->Mapper->GetCapturedImage();
  vtkSmartPointer<vtkImageData> oracle = this->UpdateOracle() ? this->Oracle->GetImage() : nullptr;
  Errors errors;
  if (!captured || !oracle)
  {
    return errors;
  }
  // Where every pixel is right no silhouette excuses one.
  std::vector<vtkSmartPointer<vtkImageData>> images;
  if (!(LargestDistance(captured, oracle) <= this->GetBound()))
  {
    images = this->ImagesBeside();
  }
  vtkIdType worst = 0;
  for (vtkIdType pixel = 0; pixel < captured->GetNumberOfPoints(); ++pixel)
  {
    const Value value = At(captured, pixel), exact = At(oracle, pixel);
    bool isNear = false;
    for (const vtkSmartPointer<vtkImageData>& image : images)
    {
      const Value beside = At(image, pixel);
      isNear = isNear || IsNothing(beside) != IsNothing(exact) ||
               (!this->IsAdditive() && Distance(beside, exact) > Jump);
    }
    const double error = Distance(value, exact);
    double& largest = isNear ? errors.NearSilhouettes : errors.Compared;
    worst = !isNear && error > largest ? pixel : worst;
    largest = std::max(largest, error);
    errors.CoveredPixels += IsNothing(exact) ? 0 : 1;
    errors.SilhouettePixels += isNear ? 1 : 0;
    errors.WrongPixels += !isNear && !(error <= this->GetBound()) ? 1 : 0;
    errors.LargestValue = std::max(errors.LargestValue, Distance(exact, Value{}));
  }
  std::cout << name << ": covered " << errors.CoveredPixels << ", largest value "
            << errors.LargestValue << ", error " << errors.Compared << " at "
            << worst % this->Renderer->GetSize()[0] << " " << worst / this->Renderer->GetSize()[0]
            << ", " << errors.WrongPixels << " pixels above " << this->GetBound() << "; "
            << errors.SilhouettePixels << " pixels near silhouettes, error "
            << errors.NearSilhouettes << "\n";
  // An image of nothing is right about nothing.
  errors.Compared = errors.CoveredPixels > 0 ? errors.Compared : -1.0;
  return errors;
}
