#include "FrameStatistics.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

namespace
{
template <class Array, class Value>
void AddColumn(vtkTable* table, const std::string& name, const Value& value)
{
  vtkNew<Array> column;
  column->SetName(name.c_str());
  column->InsertNextValue(value);
  table->AddColumn(column);
}
}

//------------------------------------------------------------------------------
void FrameStatistics::FillTable(vtkTable* table) const
{
  table->Initialize();
  AddColumn<vtkStringArray>(table, "Method", this->Method);
  AddColumn<vtkStringArray>(table, "Engine", this->Engine);
  AddColumn<vtkIdTypeArray>(table, "CellsIn", this->CellsIn);
  AddColumn<vtkIdTypeArray>(table, "CellsDrawn", this->CellsDrawn);
  AddColumn<vtkIdTypeArray>(table, "CellsSkippedTransparent", this->CellsSkippedTransparent);
  AddColumn<vtkIdTypeArray>(table, "CellsSkippedInvalid", this->CellsSkippedInvalid);
  AddColumn<vtkIdTypeArray>(table, "CellsSkippedOutside", this->CellsSkippedOutside);
  AddColumn<vtkIdTypeArray>(table, "Cycles", this->Cycles);
  AddColumn<vtkIdTypeArray>(table, "MisorderedFaces", this->MisorderedFaces);
  AddColumn<vtkIdTypeArray>(table, "RepairedPixels", this->RepairedPixels);
  AddColumn<vtkDoubleArray>(table, "SecondsPrepare", this->SecondsPrepare);
  AddColumn<vtkDoubleArray>(table, "SecondsSort", this->SecondsSort);
  AddColumn<vtkDoubleArray>(table, "SecondsProject", this->SecondsProject);
  AddColumn<vtkDoubleArray>(table, "SecondsBlend", this->SecondsBlend);
  if (this->ImageSampleDistance > 1.0)
  {
    AddColumn<vtkDoubleArray>(table, "ImageSampleDistance", this->ImageSampleDistance);
  }
  for (const auto& column : this->Further)
  {
    AddColumn<vtkDoubleArray>(table, column.first, column.second);
  }
}
