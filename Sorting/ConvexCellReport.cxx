#include "ConvexCellReport.h"

#include "ConvexCellCounts.h"
#include "CurvedCell.h"

#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <array>
#include <string>

namespace
{
// Why a cell goes out otherwise than it came in, or not at all; as in Texts.
enum Why
{
  AsItIs,
  Curved,
  NextToCurved,
  Star,
  ButForFlat,
  NonConvex,
  Folded,
  Degenerate,
  Cut,
  Refused // and by fate from here on
};
constexpr int NumberOfWhys = Refused + ConvexCellPlan::Invalid + 1;

constexpr const char* Texts[NumberOfWhys] = { "", "curved: follows the tolerance",
  "next to a curved cell that was cut", "no corner sees all: cut from a point within",
  "no point sees all: what is flat is dropped",
  "not convex: cut from a corner", "folded: its tetrahedra overlap", "repeats a point or is flat",
  "cut into tetrahedra", "", "", "zero volume", "open surface", "several pieces",
  "concave: no point sees all of it", "wrong list of faces", "", "duplicate",
  "hidden, or with a hidden point", "a point that is not finite", "imaginary",
  "wrong list of points" };

int WhyOf(const ConvexCellPlan& plan, int type)
{
  TetrahedralSplit::Shape twin;
  if (plan.Fate > ConvexCellPlan::Tetrahedra)
  {
    return Refused + plan.Fate;
  }
  if (plan.Fate == ConvexCellPlan::Whole)
  {
    return AsItIs;
  }
  const bool isCurved = CurvedCell::TwinOf(type, twin);
  return plan.Folded       ? Folded
         : plan.Replaced   ? (isCurved ? Curved : NextToCurved)
         : plan.Star       ? Star
         : plan.ButForFlat ? ButForFlat
         : plan.NonConvex  ? NonConvex
         : plan.Dropped    ? Degenerate
                           : Cut;
}

struct Row
{
  vtkIdType In = 0;
  vtkIdType Out = 0;
  vtkIdType Dropped = 0;
};

template <typename Array>
Array* AddColumn(vtkTable* table, const char* name)
{
  vtkNew<Array> column;
  column->SetName(name);
  table->AddColumn(column);
  return column;
}
}

void ConvexCellReport::Fill(const std::vector<ConvexCellPlan>& plans,
  const std::vector<unsigned char>& types, const std::vector<int>& outputs, vtkTable* report)
{
  std::vector<std::array<Row, NumberOfWhys>> rows(256);
  for (std::size_t cell = 0; cell < plans.size(); ++cell)
  {
    Row& row = rows[types[cell]][WhyOf(plans[cell], types[cell])];
    row.In += 1;
    row.Out += outputs[cell];
    row.Dropped += outputs[cell] == 0;
  }
  report->Initialize();
  auto* type = AddColumn<vtkStringArray>(report, "type");
  auto* in = AddColumn<vtkIdTypeArray>(report, "in");
  auto* out = AddColumn<vtkIdTypeArray>(report, "out");
  auto* dropped = AddColumn<vtkIdTypeArray>(report, "dropped");
  auto* why = AddColumn<vtkStringArray>(report, "why");
  for (int cellType = 0; cellType < 256; ++cellType)
  {
    for (int reason = 0; reason < NumberOfWhys; ++reason)
    {
      const Row& row = rows[cellType][reason];
      if (row.In > 0)
      {
        type->InsertNextValue(NameOfCellType(cellType));
        in->InsertNextValue(row.In);
        out->InsertNextValue(row.Out);
        dropped->InsertNextValue(row.Dropped);
        why->InsertNextValue(
          reason == Refused + ConvexCellPlan::OtherType ? ReasonAgainstType(cellType) : Texts[reason]);
      }
    }
  }
}
