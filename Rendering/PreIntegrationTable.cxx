#include "PreIntegrationTable.h"

#include "SegmentIntegral.h"
#include "TransferFunction.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

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
      const std::array<double, 3> color = integral.FindColor(unit * length);
      const size_t row = static_cast<size_t>(this->Size) * k + back;
      float* texel = &this->Texels[4 * (static_cast<size_t>(this->Size) * row + front)];
      std::transform(color.begin(), color.end(), texel,
        [](double channel) { return static_cast<float>(channel); });
      texel[3] = static_cast<float>(integral.GetMeanExtinction());
    }
  }
}

//------------------------------------------------------------------------------
void PreIntegrationTable::Build(const TransferFunction& function, const float range[2], int size)
{
  this->Size = size;
  std::copy_n(range, 2, this->Range);
  this->GreatestExtinction = 0.0f;
  for (int node = 0; node < function.GetNumberOfNodes(); ++node)
  {
    this->GreatestExtinction =
      std::max(this->GreatestExtinction, function.GetValues()[4 * static_cast<size_t>(node) + 3]);
  }
  this->Texels.resize(4 * static_cast<size_t>(size) * size * (size / 4));
  vtkSMPTools::For(0, size, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto back = static_cast<int>(begin); back < end; ++back)
      {
        this->FillRow(function, back);
      }
    });
}
