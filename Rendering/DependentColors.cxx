#include "DependentColors.h"

#include "PreparedVolume.h"
#include "VolumePropertyReader.h"
#include "vtkDataArray.h"

#include <string>

//------------------------------------------------------------------------------
void DependentColors::Prepare(const PreparedVolume& prepared, VolumePropertyReader& reader)
{
  const int components = prepared.Array->GetNumberOfComponents();
  const bool isDependent = reader.HasDependentComponents(components);
  const Kinds kind = !isDependent ? None : components == 2 ? Scalar : Direct;
  const bool isNew = this->Time < prepared.ScalarsTime || this->Time < prepared.FunctionTime;
  if (kind == None || (kind == this->Kind && !isNew))
  {
    this->Kind = kind;
    return;
  }
  this->Kind = kind;
  this->OnePerCell = prepared.Scalars.OnePerCell;
  this->Values.assign(4 * static_cast<size_t>(prepared.Array->GetNumberOfTuples()), 0.0f);
  if (kind == Scalar)
  {
    this->ReadScalar(prepared, reader);
  }
  else
  {
    this->ReadColors(prepared);
  }
  this->Time.Modified();
}

//------------------------------------------------------------------------------
void DependentColors::ReadScalar(const PreparedVolume& prepared, VolumePropertyReader& reader)
{
  ScalarField field;
  field.Build(prepared.Array, 0, this->OnePerCell, reader.FindLimits().data());
  for (size_t i = 0; i < field.Values.size(); ++i)
  {
    this->Values[4 * i] = field.Values[i];
  }
  std::vector<std::string> named;
  reader.Read(field.Normal, field.Range, this->OnePerCell, false, this->Function, named);
}

//------------------------------------------------------------------------------
void DependentColors::ReadColors(const PreparedVolume& prepared)
{
  const double unit = prepared.Array->GetDataType() == VTK_UNSIGNED_CHAR ? 1.0 / 255.0 : 1.0;
  for (vtkIdType id = 0; id < prepared.Array->GetNumberOfTuples(); ++id)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Values[4 * id + i] =
        static_cast<float>(unit * prepared.Array->GetComponent(id, i));
    }
  }
}
