#include "SightHalves.h"

#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Directions[SightHalves::NumberOfDirections][3] = { { 1, 0, 0 }, { 0, 1, 0 },
  { 0, 0, 1 }, { 1, 1, 0 }, { 1, -1, 0 }, { 1, 0, 1 }, { 1, 0, -1 }, { 0, 1, 1 }, { 0, 1, -1 },
  { 1, 1, 1 }, { 1, 1, -1 }, { 1, -1, 1 }, { -1, 1, 1 } };

double CosineTo(const double direction[3], const double towards[3])
{
  return vtkMath::Dot(direction, towards) / vtkMath::Norm(direction);
}
}

//------------------------------------------------------------------------------
void SightHalves::Build(const SignedLinks& links, const std::vector<double>& centers)
{
  this->Links = &links;
  this->Centers = &centers;
  for (std::vector<unsigned char>& halves : this->Halves)
  {
    halves.clear();
  }
}

//------------------------------------------------------------------------------
const unsigned char* SightHalves::Find(const double towards[3], unsigned char& farSide)
{
  int nearest = 0;
  for (int i = 1; i < NumberOfDirections; ++i)
  {
    if (std::abs(CosineTo(Directions[i], towards)) >
      std::abs(CosineTo(Directions[nearest], towards)))
    {
      nearest = i;
    }
  }
  farSide = CosineTo(Directions[nearest], towards) > 0.0 ? 0 : Positive;
  std::vector<unsigned char>& halves = this->Halves[nearest];
  if (halves.empty())
  {
    halves = this->Split(Directions[nearest]);
    this->MarkOwnLinks(halves);
  }
  return halves.data();
}

//------------------------------------------------------------------------------
std::vector<unsigned char> SightHalves::Split(const double direction[3]) const
{
  std::vector<unsigned char> halves(this->Centers->size() / 3, 0);
  std::vector<double> along(halves.size());
  for (std::size_t cell = 0; cell < along.size(); ++cell)
  {
    along[cell] = vtkMath::Dot(&(*this->Centers)[3 * cell], direction);
  }
  if (!along.empty())
  {
    std::vector<double> sorted(along);
    const auto middle = sorted.begin() + sorted.size() / 2;
    std::nth_element(sorted.begin(), middle, sorted.end());
    std::transform(along.begin(), along.end(), halves.begin(),
      [median = *middle](double place) { return place >= median ? Positive : 0; });
  }
  return halves;
}

//------------------------------------------------------------------------------
void SightHalves::MarkOwnLinks(std::vector<unsigned char>& halves) const
{
  std::vector<unsigned char> own(halves.size(), 0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(halves.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto cell = static_cast<int>(begin); cell < end; ++cell)
      {
        const int first = this->Links->Begin(cell);
        for (int i = 0; i < SignedLinks::FewLinks; ++i)
        {
          const bool same = halves[cell] == halves[this->Links->GetNeighbor(first + i)];
          own[cell] |= static_cast<unsigned char>((same ? 1 : 0) << i);
        }
      }
    });
  std::transform(halves.begin(), halves.end(), own.begin(), halves.begin(),
    [](unsigned char half, unsigned char links) { return half | links; });
}
