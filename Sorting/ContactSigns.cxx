#include "ContactSigns.h"

#include "ExactOrientation.h"
#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace
{
// Of a distance to a plane in floats, per unit of the eye's coordinates: rounding of the normal and
// of the sum stays below a tenth of it.
constexpr float FloatError = 1e-6f;

// Below this sine of the angle between its edges a triangle's own normal, in doubles, is too rough.
constexpr double SmallestSine = 1e-8;

// Added to a sign that the rounded look could not decide.
constexpr int Undecided = 4;

constexpr vtkIdType BlockSize = 4096;
}

//------------------------------------------------------------------------------
void ContactSigns::Build(const std::vector<double>& points,
  const std::vector<CellComplex::Contact>& contacts, const double center[3], double size)
{
  this->Points = &points;
  std::copy_n(center, 3, this->Center);
  this->Scale = size > 0.0 ? 1.0 / size : 1.0;
  this->Signs.assign(contacts.size() + 1, 0);
  for (std::vector<float>& values : this->Planes)
  {
    values.resize(contacts.size());
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(contacts.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        this->SetPlane(contacts[i], i);
      }
    });
}

//------------------------------------------------------------------------------
void ContactSigns::SetPlane(const CellComplex::Contact& contact, vtkIdType at)
{
  const double* p[3];
  for (int k = 0; k < 3; ++k)
  {
    p[k] = this->Points->data() + 3 * static_cast<size_t>(contact.Points[k]);
  }
  double u[3], v[3], normal[3], fromCenter[3];
  vtkMath::Subtract(p[1], p[0], u);
  vtkMath::Subtract(p[2], p[0], v);
  vtkMath::Subtract(p[0], this->Center, fromCenter);
  vtkMath::Cross(u, v, normal);
  const double sine = vtkMath::Norm(normal) / (vtkMath::Norm(u) * vtkMath::Norm(v));
  vtkMath::Normalize(normal);
  for (int k = 0; k < 3; ++k)
  {
    // What is not a number decides nothing: the exact sign is taken.
    this->Planes[k][at] =
      sine > SmallestSine ? static_cast<float>(normal[k]) : std::numeric_limits<float>::quiet_NaN();
  }
  this->Planes[3][at] = static_cast<float>(-vtkMath::Dot(normal, fromCenter) * this->Scale);
}

//------------------------------------------------------------------------------
bool ContactSigns::Update(const std::vector<CellComplex::Contact>& contacts, const double eye[4])
{
  float rounded[4] = { 0.0f, 0.0f, 0.0f, static_cast<float>(eye[3]) };
  double length = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double x = eye[3] == 0.0 ? eye[i] : (eye[i] - this->Center[i]) * this->Scale;
    rounded[i] = static_cast<float>(x);
    length += std::abs(x);
  }
  // A plane of the mesh is at most a diagonal away from its middle.
  const float bound = FloatError * static_cast<float>(length + 2.0 * eye[3]);
  std::atomic<int> changed(0);
  vtkSMPTools::For(0, static_cast<vtkIdType>(contacts.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      // Blocks that stay in the cache between the rounded and the exact look.
      for (vtkIdType at = begin; at < end; at += BlockSize)
      {
        const vtkIdType last = std::min(end, at + BlockSize);
        const int different = this->UpdateRounded(at, last, rounded, bound) |
                              this->DecideExactly(contacts, at, last, eye);
        if (different != 0)
        {
          changed.store(1, std::memory_order_relaxed);
        }
      }
    });
  return changed.load() != 0;
}

//------------------------------------------------------------------------------
int ContactSigns::UpdateRounded(vtkIdType begin, vtkIdType end, const float eye[4], float bound)
{
  const float *x = this->Planes[0].data(), *y = this->Planes[1].data(), *z = this->Planes[2].data(),
              *offset = this->Planes[3].data();
  const float e[4] = { eye[0], eye[1], eye[2], eye[3] };
  signed char* signs = this->Signs.data();
  int different = 0;
  for (vtkIdType i = begin; i < end; ++i)
  {
    const float distance = x[i] * e[0] + y[i] * e[1] + z[i] * e[2] + offset[i] * e[3];
    const int sign = (distance > bound) - (distance < -bound);
    // An undecided sign keeps the old one in itself, for the exact one to be compared with.
    const int old = signs[i];
    different |= sign != 0 ? sign ^ old : 0;
    signs[i] = static_cast<signed char>(sign != 0 ? sign : old + Undecided);
  }
  return different;
}

//------------------------------------------------------------------------------
int ContactSigns::DecideExactly(const std::vector<CellComplex::Contact>& contacts, vtkIdType begin,
  vtkIdType end, const double eye[4])
{
  const double* points = this->Points->data();
  int different = 0;
  for (vtkIdType i = begin; i < end; ++i)
  {
    if (this->Signs[i] > 1)
    {
      const int sign = ExactOrientation::SideOfEye(points, contacts[i].Points, eye);
      different |= sign ^ (this->Signs[i] - Undecided);
      this->Signs[i] = static_cast<signed char>(sign);
    }
  }
  return different;
}
