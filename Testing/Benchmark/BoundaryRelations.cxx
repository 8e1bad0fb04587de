#include "BoundaryRelations.h"

#include "ExactOrientation.h"
#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

//------------------------------------------------------------------------------
void BoundaryRelations::Build(const CellComplex& complex)
{
  this->Complex = &complex;
  this->Tree.Build(complex);
  this->FindSpheres();
  this->SetPlanes();
  this->LinkCells();
}

//------------------------------------------------------------------------------
void BoundaryRelations::FindSpheres()
{
  this->Spheres.clear();
  for (const BoundaryBSP::Fragment& fragment : this->Tree.GetFragments())
  {
    const BoundaryBSP::Point* p = this->Tree.GetCorners(fragment);
    const int count = fragment.End - fragment.Begin;
    std::array<double, 4> sphere{ { 0.0, 0.0, 0.0, 0.0 } };
    for (int i = 0; i < 3 * count; ++i)
    {
      sphere[i % 3] += p[i / 3][i % 3] / count;
    }
    for (int i = 0; i < count; ++i)
    {
      const double square = vtkMath::Distance2BetweenPoints(p[i].data(), sphere.data());
      // A little more than rounding can take away.
      sphere[3] = std::max(sphere[3], 1.001 * std::sqrt(square));
    }
    this->Spheres.push_back(sphere);
  }
}

//------------------------------------------------------------------------------
void BoundaryRelations::FindShapes(const double eye[4])
{
  this->Shapes.resize(this->Spheres.size());
  const double square = vtkMath::Dot(eye, eye);
  for (std::size_t at = 0; at < this->Spheres.size(); ++at)
  {
    const std::array<double, 4>& sphere = this->Spheres[at];
    Shape& shape = this->Shapes[at];
    if (eye[3] == 0.0)
    {
      const double along = vtkMath::Dot(sphere.data(), eye) / square;
      for (int i = 0; i < 3; ++i)
      {
        shape.Axis[i] = sphere[i] - along * eye[i];
      }
      shape.Sine = sphere[3];
      continue;
    }
    vtkMath::Subtract(sphere.data(), eye, shape.Axis);
    const double distance = vtkMath::Normalize(shape.Axis);
    shape.Sine = distance > sphere[3] ? sphere[3] / distance : 1.0;
    shape.Cosine = std::sqrt(1.0 - shape.Sine * shape.Sine);
  }
}

//------------------------------------------------------------------------------
bool BoundaryRelations::MayOverlap(bool parallel, int first, int second) const
{
  const Shape& a = this->Shapes[first];
  const Shape& b = this->Shapes[second];
  if (parallel)
  {
    const double reach = a.Sine + b.Sine;
    return vtkMath::Distance2BetweenPoints(a.Axis, b.Axis) <= reach * reach;
  }
  // About an eye within one of the spheres there is no cone.
  return a.Sine >= 1.0 || b.Sine >= 1.0 ||
         vtkMath::Dot(a.Axis, b.Axis) >= a.Cosine * b.Cosine - a.Sine * b.Sine - 1e-9;
}

//------------------------------------------------------------------------------
void BoundaryRelations::SetPlanes()
{
  const std::vector<double>& points = this->Complex->Points;
  this->Planes.resize(this->Complex->Contacts.size());
  for (std::size_t contact = 0; contact < this->Planes.size(); ++contact)
  {
    const int* ids = this->Complex->Contacts[contact].Points;
    const double* p[3] = { &points[3 * ids[0]], &points[3 * ids[1]], &points[3 * ids[2]] };
    Plane& plane = this->Planes[contact];
    plane.Offset = 0.0;
    double size = 0.0, far = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const double a = (p[1][j] - p[0][j]) * (p[2][k] - p[0][k]);
      const double b = (p[1][k] - p[0][k]) * (p[2][j] - p[0][j]);
      plane.Normal[i] = a - b;
      plane.Offset += (a - b) * p[0][i];
      size = std::max(size, std::abs(a) + std::abs(b));
      far = std::max(far, std::abs(p[0][i]));
    }
    // Of the offset; the eye's own share is added for each eye.
    plane.Error = 64.0 * std::numeric_limits<double>::epsilon() * size;
    plane.Offset = std::isfinite(plane.Offset) ? plane.Offset : 0.0;
  }
}

//------------------------------------------------------------------------------
void BoundaryRelations::LinkCells()
{
  this->LinkOffsets.assign(this->Complex->NumberOfCells + 1, 0);
  for (const CellComplex::Contact& contact : this->Complex->Contacts)
  {
    ++this->LinkOffsets[contact.Cells[0] + 1];
    ++this->LinkOffsets[contact.Cells[1] + 1];
  }
  std::partial_sum(this->LinkOffsets.begin(), this->LinkOffsets.end(), this->LinkOffsets.begin());
  this->Links.resize(2 * this->Complex->Contacts.size());
  std::vector<int> next = this->LinkOffsets;
  for (std::size_t at = 0; at < this->Complex->Contacts.size(); ++at)
  {
    const CellComplex::Contact& contact = this->Complex->Contacts[at];
    const int name = static_cast<int>(at);
    this->Links[next[contact.Cells[0]]++] = { contact.Cells[1], name, 1 };
    this->Links[next[contact.Cells[1]]++] = { contact.Cells[0], name, -1 };
  }
}

//------------------------------------------------------------------------------
void BoundaryRelations::FindSigns(const double eye[4])
{
  this->Signs.resize(this->Planes.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Planes.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      const double* points = this->Complex->Points.data();
      for (vtkIdType at = begin; at < end; ++at)
      {
        const Plane& plane = this->Planes[at];
        const int* ids = this->Complex->Contacts[at].Points;
        const double* p = points + 3 * ids[0];
        double value = -plane.Offset * eye[3], reach = 0.0;
        for (int i = 0; i < 3; ++i)
        {
          value += plane.Normal[i] * eye[i];
          reach += std::abs(eye[i]) + eye[3] * std::abs(p[i]);
        }
        this->Signs[at] =
          std::abs(value) > plane.Error * reach
            ? (value > 0.0 ? 1 : -1)
            : ExactOrientation::SideOfEye(p, points + 3 * ids[1], points + 3 * ids[2], eye);
      }
    });
}

//------------------------------------------------------------------------------
void BoundaryRelations::CountWaiting()
{
  const int cells = this->Complex->NumberOfCells;
  this->Waiting.assign(cells, 0);
  this->Drawn.assign(cells, 0);
  this->FirstAdded.assign(cells, -1);
  this->Added.clear();
  this->Partly.clear();
  for (std::size_t at = 0; at < this->Signs.size(); ++at)
  {
    if (this->Signs[at] != 0)
    {
      // The eye's own side is the nearer one.
      ++this->Waiting[this->Complex->Contacts[at].Cells[this->Signs[at] > 0 ? 0 : 1]];
    }
  }
  for (const BoundaryBSP::Visit& visit : this->Visits)
  {
    if (visit.Side < 0)
    {
      const int triangle = this->Tree.GetFragments()[visit.Fragment].Triangle;
      ++this->Waiting[this->Complex->Boundary[triangle].Cell];
    }
  }
}

//------------------------------------------------------------------------------
void BoundaryRelations::Release(int cell, std::vector<vtkIdType>& order)
{
  this->Stack.assign(1, cell);
  auto decrease = [this](int nearer)
  {
    if (--this->Waiting[nearer] == 0)
    {
      this->Stack.push_back(nearer);
    }
  };
  while (!this->Stack.empty())
  {
    const int next = this->Stack.back();
    this->Stack.pop_back();
    order.push_back(next);
    this->Drawn[next] = 1;
    for (int at = this->LinkOffsets[next]; at < this->LinkOffsets[next + 1]; ++at)
    {
      const Link& link = this->Links[at];
      if (this->Signs[link.Contact] * link.Side < 0)
      {
        decrease(link.Neighbor);
      }
    }
    for (int at = this->FirstAdded[next]; at >= 0; at = this->Added[at].Next)
    {
      decrease(this->Added[at].Nearer);
    }
  }
}

//------------------------------------------------------------------------------
bool BoundaryRelations::Separates(const double normal[3], const double origin[3],
  const BoundaryBSP::Fragment& a, const BoundaryBSP::Fragment& b) const
{
  double low[2] = { 1e300, 1e300 }, high[2] = { -1e300, -1e300 };
  const BoundaryBSP::Fragment* both[2] = { &a, &b };
  for (int i = 0; i < 2; ++i)
  {
    const BoundaryBSP::Point* p = this->Tree.GetCorners(*both[i]);
    for (int at = 0; at < both[i]->End - both[i]->Begin; ++at)
    {
      const double side = normal[0] * (p[at][0] - origin[0]) + normal[1] * (p[at][1] - origin[1]) +
                          normal[2] * (p[at][2] - origin[2]);
      low[i] = std::min(low[i], side);
      high[i] = std::max(high[i], side);
    }
  }
  const double slack = 1e-12 * (high[0] - low[0] + high[1] - low[1]);
  // Where both lie within the plane it tells nothing.
  const bool apart =
    (low[0] >= -slack && high[1] <= slack) || (high[0] <= slack && low[1] >= -slack);
  return apart && high[0] - low[0] + high[1] - low[1] > 0.0;
}

//------------------------------------------------------------------------------
bool BoundaryRelations::AnEdgeSeparates(
  const double eye[4], const BoundaryBSP::Fragment& a, const BoundaryBSP::Fragment& b) const
{
  const BoundaryBSP::Point* p = this->Tree.GetCorners(a);
  const int count = a.End - a.Begin;
  for (int edge = 0; edge < count; ++edge)
  {
    const BoundaryBSP::Point& from = p[edge];
    const BoundaryBSP::Point& to = p[(edge + 1) % count];
    double along[3], ray[3], normal[3];
    for (int i = 0; i < 3; ++i)
    {
      along[i] = to[i] - from[i];
      ray[i] = eye[i] - eye[3] * from[i];
    }
    vtkMath::Cross(along, ray, normal);
    if (this->Separates(normal, from.data(), a, b))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool BoundaryRelations::CornersSeparate(
  const double eye[4], const BoundaryBSP::Fragment& a, const BoundaryBSP::Fragment& b) const
{
  const BoundaryBSP::Point* p = this->Tree.GetCorners(a);
  const BoundaryBSP::Point* q = this->Tree.GetCorners(b);
  for (int i = 0; i < a.End - a.Begin; ++i)
  {
    for (int j = 0; j < b.End - b.Begin; ++j)
    {
      double first[3], second[3], normal[3];
      vtkMath::Subtract(p[i].data(), eye, first);
      vtkMath::Subtract(q[j].data(), eye, second);
      vtkMath::Cross(first, second, normal);
      if (this->Separates(normal, eye, a, b))
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool BoundaryRelations::Overlap(const double eye[4], int first, int second) const
{
  const BoundaryBSP::Fragment& a = this->Tree.GetFragments()[first];
  const BoundaryBSP::Fragment& b = this->Tree.GetFragments()[second];
  if (!this->MayOverlap(eye[3] == 0.0, first, second))
  {
    return false;
  }
  if (this->AnEdgeSeparates(eye, a, b) || this->AnEdgeSeparates(eye, b, a))
  {
    return false;
  }
  // About an eye within the mesh, a plane through a corner of either may be the only one.
  return eye[3] == 0.0 || !this->CornersSeparate(eye, a, b);
}

//------------------------------------------------------------------------------
void BoundaryRelations::WaitForPartlyProjected(const double eye[4], int fragment, int cell)
{
  std::size_t kept = 0;
  for (const int partly : this->Partly)
  {
    const int triangle = this->Tree.GetFragments()[partly].Triangle;
    const int behind = this->Complex->Boundary[triangle].Cell;
    if (this->Drawn[behind])
    {
      continue;
    }
    this->Partly[kept++] = partly;
    if (behind != cell && this->Overlap(eye, partly, fragment))
    {
      this->Added.push_back({ cell, this->FirstAdded[behind] });
      this->FirstAdded[behind] = static_cast<int>(this->Added.size()) - 1;
      ++this->Waiting[cell];
    }
  }
  this->Partly.resize(kept);
}

//------------------------------------------------------------------------------
void BoundaryRelations::VisitBoundary(const double eye[4], std::vector<vtkIdType>& order)
{
  for (const BoundaryBSP::Visit& visit : this->Visits)
  {
    const int triangle = this->Tree.GetFragments()[visit.Fragment].Triangle;
    const int cell = this->Complex->Boundary[triangle].Cell;
    if (visit.Side > 0 && !this->Drawn[cell])
    {
      this->Partly.push_back(visit.Fragment);
    }
    else if (visit.Side < 0)
    {
      this->WaitForPartlyProjected(eye, visit.Fragment, cell);
      if (--this->Waiting[cell] == 0)
      {
        this->Release(cell, order);
      }
    }
  }
}

//------------------------------------------------------------------------------
void BoundaryRelations::AppendLeft(const double eye[4], std::vector<vtkIdType>& order)
{
  const auto begin = static_cast<std::ptrdiff_t>(order.size());
  for (int cell = 0; cell < this->Complex->NumberOfCells; ++cell)
  {
    if (!this->Drawn[cell])
    {
      order.push_back(cell);
    }
  }
  auto distance = [&](vtkIdType cell)
  {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double x = this->Complex->Centers[3 * cell + i];
      sum += eye[3] == 0.0 ? -x * eye[i] : (x - eye[i]) * (x - eye[i]);
    }
    return sum;
  };
  std::sort(order.begin() + begin, order.end(),
    [&](vtkIdType a, vtkIdType b) { return distance(a) > distance(b); });
  this->LeftCells = static_cast<int>(order.size() - begin);
}

//------------------------------------------------------------------------------
void BoundaryRelations::Sort(const double eye[4], std::vector<vtkIdType>& order)
{
  order.clear();
  this->FindSigns(eye);
  this->Tree.Traverse(eye, this->Visits);
  this->CountWaiting();
  this->FindShapes(eye);
  for (int cell = 0; cell < this->Complex->NumberOfCells; ++cell)
  {
    // Nothing behind it, and no ray enters it from outside: the eye is within, or sees it edge-on.
    if (this->Waiting[cell] == 0 && !this->Drawn[cell])
    {
      this->Release(cell, order);
    }
  }
  this->VisitBoundary(eye, order);
  this->AppendLeft(eye, order);
}
