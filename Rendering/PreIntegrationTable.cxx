#include "PreIntegrationTable.h"

#include "SegmentIntegral.h"
#include "TransferFunction.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <new>

namespace
{
void Store(const std::array<double, 3>& color, double fourth, float* texel)
{
  std::transform(color.begin(), color.end(), texel,
    [](double channel) { return static_cast<float>(channel); });
  texel[3] = static_cast<float>(fourth);
}
}

//------------------------------------------------------------------------------
double PreIntegrationTable::GetGreatestLength() const
{
  return std::log2(this->Size / 4);
}

//------------------------------------------------------------------------------
void PreIntegrationTable::FillRow(const TransferFunction& function, int back)
{
  const int lengths = this->Size / 4;
  const double step = (this->Range[1] - this->Range[0]) / (this->Size - 1.0);
  const double unit = this->GreatestExtinction > 0.0f ? 1.0 / this->GreatestExtinction : 0.0;
  for (int front = 0; front < this->Size; ++front)
  {
    const SegmentIntegral integral(
      function, this->Range[0] + step * front, this->Range[0] + step * back);
    for (int k = 0; k < lengths; ++k)
    {
      const double length = -std::log2(1.0 - static_cast<double>(k) / lengths);
      const SegmentIntegral::Means means = integral.FindMeans(unit * length);
      const size_t row = static_cast<size_t>(this->Size) * k + back;
      const size_t texel = 4 * (static_cast<size_t>(this->Size) * row + front);
      Store(means.Color, integral.GetMeanExtinction(), &this->Texels[texel]);
      if (this->IsLit())
      {
        const double variance = means.AheadSquared - means.Ahead * means.Ahead;
        Store(means.Front, means.Ahead, &this->Front[texel]);
        Store({ { means.Color[0] - means.Front[0], means.Color[1] - means.Front[1],
                means.Color[2] - means.Front[2] } },
          std::sqrt(std::max(variance, 0.0)), &this->Back[texel]);
      }
    }
  }
}

//------------------------------------------------------------------------------
bool PreIntegrationTable::Allocate()
{
  const size_t values = static_cast<size_t>(this->Size) * this->Size * this->Size;
  try
  {
    this->Texels.resize(values);
    this->Front.resize(this->Lit ? values : 0);
    this->Back.resize(this->Lit ? values : 0);
    return true;
  }
  catch (const std::bad_alloc&)
  {
    for (std::vector<float>* texels : { &this->Texels, &this->Front, &this->Back })
    {
      std::vector<float>().swap(*texels);
    }
    return false;
  }
}

//------------------------------------------------------------------------------
bool PreIntegrationTable::Build(
  const TransferFunction& function, const float range[2], int size, bool isLit)
{
  this->Size = size;
  this->Lit = isLit;
  std::copy_n(range, 2, this->Range);
  this->GreatestExtinction = 0.0f;
  for (int node = 0; node < function.GetNumberOfNodes(); ++node)
  {
    this->GreatestExtinction =
      std::max(this->GreatestExtinction, function.GetValues()[4 * static_cast<size_t>(node) + 3]);
  }
  if (!this->Allocate())
  {
    return false;
  }
  vtkSMPTools::For(0, size, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto back = static_cast<int>(begin); back < end; ++back)
      {
        this->FillRow(function, back);
      }
    });
  return true;
}
