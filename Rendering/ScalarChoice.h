#ifndef ScalarChoice_h
#define ScalarChoice_h

#include <string>

class vtkAbstractVolumeMapper;
class vtkDataArray;
class vtkDataSet;

/// The array that a mapper's scalar mode and array choice name.
class ScalarChoice
{
public:
  ScalarChoice(vtkAbstractVolumeMapper* mapper, vtkDataSet* data);

  /// The same array in data that were made from these; null where it was not carried over.
  vtkDataArray* FindIn(vtkDataSet* made, vtkAbstractVolumeMapper* mapper) const;

  /// Null where there is none; Problem says which one was asked for and how to choose another.
  vtkDataArray* Array = nullptr;
  bool OnePerCell = false;
  std::string Problem;

private:
  void Describe(vtkAbstractVolumeMapper* mapper);
};

#endif
