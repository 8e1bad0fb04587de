#ifndef SideCut_h
#define SideCut_h

#include "ConvexCellsTesting.h"

#include <functional>

/// The triangles of a cell's side as vtkConvexCells documents them, written apart from the filter.
namespace SideCut
{
using Ids = std::vector<vtkIdType>;
/// The point of an id.
using Look = std::function<ConvexCellsTesting::Point(vtkIdType)>;
using Triangle = std::function<void(vtkIdType, vtkIdType, vtkIdType)>;

/// `side` from its smallest id towards the smaller neighbour.
void Visit(const Ids& side, const Look& at, const Triangle& visit);
/// From its first id.
void VisitFan(const Ids& side, const Triangle& visit);
/// Whether an edge does on the one before it.
bool RunsBack(const Ids& side, const Look& at);
}

#endif
