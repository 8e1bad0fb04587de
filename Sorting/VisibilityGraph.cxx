#include "VisibilityGraph.h"

#include "Convexification.h"
#include "ExactOrientation.h"
#include "MortonOrder.h"
#include "StrongComponents.h"
#include "vtkBoundingBox.h"
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
}

//------------------------------------------------------------------------------
void VisibilityGraph::Build(const CellComplex& complex, const ImaginaryCells* imaginary)
{
  this->Points = &complex.Points;
  this->NumberOfMeshCells = complex.NumberOfCells;
  this->TakeCenters(complex, imaginary);
  this->NumberCells();
  this->TakeContacts(complex, imaginary);
  this->LinkCells();
  this->SetPlanes();
  this->Signs.assign(this->Contacts.size(), 0);
  this->Sorted = false;
}

//------------------------------------------------------------------------------
void VisibilityGraph::TakeCenters(const CellComplex& complex, const ImaginaryCells* imaginary)
{
  this->Centers = complex.Centers;
  const size_t meshPoints = complex.Points.size() / 3;
  for (int cell = 0; imaginary && cell < imaginary->GetNumberOfCells(); ++cell)
  {
    const int begin = imaginary->FaceOffsets[imaginary->CellOffsets[cell]];
    const int end = imaginary->FaceOffsets[imaginary->CellOffsets[cell + 1]];
    double center[3] = { 0.0, 0.0, 0.0 };
    for (int i = begin; i < end; ++i)
    {
      const size_t point = static_cast<size_t>(imaginary->FaceCorners[i]);
      const double* x = point < meshPoints ? &complex.Points[3 * point]
                                           : &imaginary->Points[3 * (point - meshPoints)];
      for (int k = 0; k < 3; ++k)
      {
        center[k] += x[k] / (end - begin);
      }
    }
    this->Centers.insert(this->Centers.end(), center, center + 3);
  }
}

//------------------------------------------------------------------------------
void VisibilityGraph::NumberCells()
{
  vtkBoundingBox box;
  for (size_t i = 0; i < this->Centers.size(); i += 3)
  {
    box.AddPoint(this->Centers[i], this->Centers[i + 1], this->Centers[i + 2]);
  }
  if (box.IsValid())
  {
    box.GetCenter(this->Center);
    this->Scale = box.GetDiagonalLength() > 0.0 ? 1.0 / box.GetDiagonalLength() : 1.0;
  }
  this->InputId = MortonOrder::Find(this->Centers, box);
  this->OwnId.resize(this->InputId.size());
  std::vector<double> centers(this->Centers.size());
  for (size_t own = 0; own < this->InputId.size(); ++own)
  {
    this->OwnId[this->InputId[own]] = static_cast<int>(own);
    std::copy_n(&this->Centers[3 * static_cast<size_t>(this->InputId[own])], 3, &centers[3 * own]);
  }
  this->Centers.swap(centers);
}

//------------------------------------------------------------------------------
void VisibilityGraph::TakeContacts(const CellComplex& complex, const ImaginaryCells* imaginary)
{
  std::vector<CellComplex::Contact> contacts = complex.Contacts;
  if (imaginary)
  {
    contacts.insert(contacts.end(), imaginary->Contacts.begin(), imaginary->Contacts.end());
  }
  // By the first of their cells, so that contacts lie in memory as their cells do.
  std::vector<int> next(this->InputId.size() + 1, 0);
  for (CellComplex::Contact& contact : contacts)
  {
    contact.Cells[0] = this->OwnId[contact.Cells[0]];
    contact.Cells[1] = this->OwnId[contact.Cells[1]];
    ++next[std::min(contact.Cells[0], contact.Cells[1]) + 1];
  }
  for (size_t i = 1; i < next.size(); ++i)
  {
    next[i] += next[i - 1];
  }
  this->Contacts.resize(contacts.size());
  for (const CellComplex::Contact& contact : contacts)
  {
    this->Contacts[next[std::min(contact.Cells[0], contact.Cells[1])]++] = contact;
  }
}

//------------------------------------------------------------------------------
void VisibilityGraph::LinkCells()
{
  const size_t cells = this->InputId.size();
  this->LinkOffsets.assign(cells + 1, 0);
  for (const CellComplex::Contact& contact : this->Contacts)
  {
    ++this->LinkOffsets[contact.Cells[0] + 1];
    ++this->LinkOffsets[contact.Cells[1] + 1];
  }
  for (size_t i = 1; i <= cells; ++i)
  {
    this->LinkOffsets[i] += this->LinkOffsets[i - 1];
  }
  std::vector<int> next(this->LinkOffsets.begin(), this->LinkOffsets.end() - 1);
  this->Links.resize(2 * this->Contacts.size());
  for (int i = 0; i < static_cast<int>(this->Contacts.size()); ++i)
  {
    for (int side = 0; side < 2; ++side)
    {
      const int cell = this->Contacts[i].Cells[side];
      this->Links[next[cell]++] = { this->Contacts[i].Cells[1 - side], 2 * i + side };
    }
  }
}

//------------------------------------------------------------------------------
void VisibilityGraph::SetPlanes()
{
  this->Planes.resize(this->Contacts.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Contacts.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const double* p[3];
        for (int k = 0; k < 3; ++k)
        {
          p[k] = this->Points->data() + 3 * static_cast<size_t>(this->Contacts[i].Points[k]);
        }
        double u[3], v[3], normal[3], fromCenter[3];
        vtkMath::Subtract(p[1], p[0], u);
        vtkMath::Subtract(p[2], p[0], v);
        vtkMath::Subtract(p[0], this->Center, fromCenter);
        vtkMath::Cross(u, v, normal);
        const double sine = vtkMath::Norm(normal) / (vtkMath::Norm(u) * vtkMath::Norm(v));
        vtkMath::Normalize(normal);
        Plane& plane = this->Planes[i];
        std::copy_n(normal, 3, plane.Normal);
        // What is not a number decides nothing: the exact sign is taken.
        plane.Offset = sine > SmallestSine
                         ? static_cast<float>(-vtkMath::Dot(normal, fromCenter) * this->Scale)
                         : std::numeric_limits<float>::quiet_NaN();
      }
    });
}

//------------------------------------------------------------------------------
bool VisibilityGraph::Sort(const double eye[4], bool centersFirst)
{
  const bool changed = this->FindSigns(eye);
  if (this->Sorted && !changed && centersFirst == this->SortedByCenters)
  {
    return false;
  }
  this->Sorted = true;
  this->SortedByCenters = centersFirst;
  this->Order.clear();
  this->Order.reserve(static_cast<size_t>(this->NumberOfMeshCells));
  this->GroupCells.clear();
  this->GroupOffsets.assign(1, 0);
  this->CountFarther();
  this->FindSources(eye, centersFirst);
  this->SortTopologically();
  if (static_cast<int>(this->Order.size()) < this->NumberOfMeshCells)
  {
    this->SortGroups(eye);
  }
  return true;
}

//------------------------------------------------------------------------------
signed char VisibilityGraph::SignOf(
  int contact, const float eye[4], float scale, const double exact[4]) const
{
  const Plane& plane = this->Planes[contact];
  const float distance = plane.Normal[0] * eye[0] + plane.Normal[1] * eye[1] +
                         plane.Normal[2] * eye[2] + plane.Offset * eye[3];
  const float bound = FloatError * scale;
  if (distance > bound || distance < -bound)
  {
    return distance > 0.0f ? 1 : -1;
  }
  const double* points = this->Points->data();
  const int* p = this->Contacts[contact].Points;
  return static_cast<signed char>(
    ExactOrientation::SideOfEye(points + 3 * static_cast<size_t>(p[0]),
      points + 3 * static_cast<size_t>(p[1]), points + 3 * static_cast<size_t>(p[2]), exact));
}

//------------------------------------------------------------------------------
bool VisibilityGraph::FindSigns(const double eye[4])
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
  const float scale = static_cast<float>(length + 2.0 * eye[3]);
  std::atomic<bool> changed(false);
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Contacts.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      int different = 0;
      for (vtkIdType i = begin; i < end; ++i)
      {
        const signed char sign = this->SignOf(static_cast<int>(i), rounded, scale, eye);
        different |= sign ^ this->Signs[i];
        this->Signs[i] = sign;
      }
      if (different != 0)
      {
        changed.store(true, std::memory_order_relaxed);
      }
    });
  return changed.load();
}

//------------------------------------------------------------------------------
void VisibilityGraph::CountFarther()
{
  const auto cells = static_cast<vtkIdType>(this->InputId.size());
  this->Waiting.resize(this->InputId.size());
  vtkSMPTools::For(0, cells,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        int waiting = 0;
        for (int i = this->LinkOffsets[cell]; i < this->LinkOffsets[cell + 1]; ++i)
        {
          waiting += this->IsFarther(this->Links[i]) ? 1 : 0;
        }
        this->Waiting[cell] = waiting;
      }
    });
}

//------------------------------------------------------------------------------
void VisibilityGraph::FindSources(const double eye[4], bool centersFirst)
{
  this->Stack.clear();
  for (int cell = 0; cell < static_cast<int>(this->Waiting.size()); ++cell)
  {
    if (this->Waiting[cell] == 0)
    {
      this->Stack.push_back(cell);
    }
  }
  if (centersFirst)
  {
    // The stack's end is taken first.
    std::sort(this->Stack.begin(), this->Stack.end(),
      [&](int a, int b) { return this->GetDistance(a, eye) < this->GetDistance(b, eye); });
  }
}

//------------------------------------------------------------------------------
double VisibilityGraph::GetDistance(int cell, const double eye[4]) const
{
  const double* center = &this->Centers[3 * static_cast<size_t>(cell)];
  return eye[3] == 0.0 ? -vtkMath::Dot(center, eye) : vtkMath::Distance2BetweenPoints(center, eye);
}

//------------------------------------------------------------------------------
void VisibilityGraph::Emit(int cell)
{
  if (this->InputId[cell] < this->NumberOfMeshCells)
  {
    this->Order.push_back(this->InputId[cell]);
  }
}

//------------------------------------------------------------------------------
void VisibilityGraph::SortTopologically()
{
  while (!this->Stack.empty())
  {
    const int cell = this->Stack.back();
    this->Stack.pop_back();
    this->Emit(cell);
    for (int i = this->LinkOffsets[cell]; i < this->LinkOffsets[cell + 1]; ++i)
    {
      const Link& link = this->Links[i];
      if (this->IsNearer(link) && --this->Waiting[link.Neighbor] == 0)
      {
        this->Stack.push_back(link.Neighbor);
      }
    }
  }
}

//------------------------------------------------------------------------------
void VisibilityGraph::AppendGroup(std::vector<int>& group, const double eye[4])
{
  std::sort(group.begin(), group.end(),
    [&](int a, int b) { return this->GetDistance(a, eye) > this->GetDistance(b, eye); });
  const auto isMesh = [&](int cell) { return this->InputId[cell] < this->NumberOfMeshCells; };
  const bool isGroup = std::count_if(group.begin(), group.end(), isMesh) > 1;
  for (const int cell : group)
  {
    this->Emit(cell);
    if (isGroup && isMesh(cell))
    {
      this->GroupCells.push_back(this->InputId[cell]);
    }
  }
  if (isGroup)
  {
    this->GroupOffsets.push_back(static_cast<vtkIdType>(this->GroupCells.size()));
  }
}

//------------------------------------------------------------------------------
void VisibilityGraph::SortGroups(const double eye[4])
{
  // What is left waits for itself. Against the edges, from near to far: then a component is given
  // out after all that lie behind it.
  StrongComponents components(static_cast<int>(this->InputId.size()));
  const auto getEdge = [&](int cell, int edge)
  {
    const int at = this->LinkOffsets[cell] + edge;
    if (at >= this->LinkOffsets[cell + 1])
    {
      return -2;
    }
    const Link& link = this->Links[at];
    return this->IsFarther(link) && this->Waiting[link.Neighbor] > 0 ? link.Neighbor : -1;
  };
  for (int cell = 0; cell < static_cast<int>(this->InputId.size()); ++cell)
  {
    if (this->Waiting[cell] > 0 && !components.HasSeen(cell))
    {
      components.Walk(
        cell, getEdge, [&](std::vector<int>& group) { this->AppendGroup(group, eye); });
    }
  }
}
