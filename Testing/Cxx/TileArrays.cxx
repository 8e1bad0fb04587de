#include "TileArrays.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double Spikes[3] = { 0.2, 0.5, 0.8 };
constexpr double SpikeWidth = 0.02;

double SpikyOpacity(double x)
{
  double opacity = 0.0;
  for (const double spike : Spikes)
  {
    opacity = std::max(opacity, 5.0 * (1.0 - std::abs(x - spike) / SpikeWidth));
  }
  return opacity;
}

double SmoothOpacity(double x)
{
  return x < 0.3 ? 0.02 + 0.6 * x : 0.2 + (x - 0.3) * 0.8 / 0.7;
}
}

//------------------------------------------------------------------------------
TileArrays::TileArrays(int n)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<float> shake(-0.2f, 0.2f);
  const int side = n + 1;
  for (int at = 0; at < side * side * side; ++at)
  {
    const int index[3] = { at % side, at / side % side, at / side / side };
    const bool isInside = std::all_of(index, index + 3, [n](int i) { return i > 0 && i < n; });
    float point[3];
    for (int k = 0; k < 3; ++k)
    {
      point[k] = 2.0f * (static_cast<float>(index[k]) + (isInside ? shake(random) : 0.0f)) /
          static_cast<float>(n) - 1.0f;
    }
    this->Points.insert(this->Points.end(), { point[0], point[1], point[2], 0.0f });
    this->Scalars.push_back(
      0.5f + 0.5f * std::sin(3.0f * point[0]) * std::cos(2.0f * point[1] + point[2]));
  }
  const int axes[6][3] = { { 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 }, { 1, 2, 0 }, { 2, 0, 1 },
    { 2, 1, 0 } };
  for (int at = 0; at < n * n * n; ++at)
  {
    const int corner[3] = { at % n, at / n % n, at / n / n };
    for (const auto& way : axes)
    {
      this->AddCell(corner, way, side);
    }
  }
}

//------------------------------------------------------------------------------
void TileArrays::AddCell(const int (&corner)[3], const int (&axes)[3], int side)
{
  int index[3] = { corner[0], corner[1], corner[2] };
  auto id = [&] { return index[0] + side * (index[1] + side * index[2]); };
  int ids[4] = { id(), 0, 0, 0 };
  for (int k = 0; k < 3; ++k)
  {
    ++index[axes[k]];
    ids[k + 1] = id();
  }
  std::sort(ids, ids + 4);
  this->Corners.insert(this->Corners.end(), ids, ids + 4);
}

//------------------------------------------------------------------------------
void TileArrays::SetFunction(bool spiky, double unitDistance)
{
  std::vector<double> nodes = { 0.0, 0.3, 1.0 };
  for (const double spike : Spikes)
  {
    nodes.insert(nodes.end(), { spike - SpikeWidth, spike, spike + SpikeWidth });
  }
  this->SetOpacity(nodes, spiky ? SpikyOpacity : SmoothOpacity, unitDistance);
}

//------------------------------------------------------------------------------
void TileArrays::SetOpacity(
  const std::vector<double>& nodes, const std::function<double(double)>& opacity, double unitDistance)
{
  const double range[2] = { 0.0, 1.0 };
  this->Function.Build(
    nodes,
    [&opacity](double x)
    { return TransferFunction::Sample{ { 0.1 + 0.8 * x, 0.5, 0.8 - 0.7 * x, opacity(x) } }; },
    range, range, unitDistance);
  this->Scene.Function = &this->Function;
}

//------------------------------------------------------------------------------
void TileArrays::SetMesh()
{
  this->Engine.SetMesh(this->Points, this->Corners);
  this->Engine.SetScalars(this->Scalars, false);
}

//------------------------------------------------------------------------------
void TileArrays::LookFrom(const glm::dvec3& eye, double angle, int width, int height)
{
  const glm::dvec3 up = std::abs(eye.z) < 0.9 * glm::length(eye) ? glm::dvec3(0.0, 0.0, 1.0)
                                                                 : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dmat4 view = glm::lookAt(eye, glm::dvec3(0.0), up);
  this->Scene.Camera.MeshToView = view;
  this->Scene.Camera.ViewToWorld = glm::inverse(view);
  this->Scene.Camera.ViewToClip =
    glm::perspective(angle * Pi / 180.0, static_cast<double>(width) / height, 0.01, 20.0);
  this->Scene.Camera.Width = width;
  this->Scene.Camera.Height = height;
}

//------------------------------------------------------------------------------
double TileArrays::LargestDifference(
  const std::vector<float>& a, const std::vector<float>& b)
{
  double largest = a.size() == b.size() ? 0.0 : 1e30;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    largest = std::max(largest, std::abs(double(a[i]) - b[i]));
  }
  return largest;
}
