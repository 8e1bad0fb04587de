#ifndef MapperInput_h
#define MapperInput_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkAbstractVolumeMapper;
class vtkConvexCells;
class vtkDataObject;
class vtkDataSet;
class vtkUnstructuredGridBase;

/**
 * @class MapperInput
 * @brief Any data set, or all blocks of a composite one, as one unstructured grid.
 *
 * An unstructured grid is taken as it is. All else goes through vtkAppendFilter, again where a
 * block, or the mapper's choice of an array, has changed. Blocks that lack the array, or have it
 * with another type or number of components than the first that has it, are left out.
 */
class MapperInput
{
public:
  /// Null where there is none.
  vtkUnstructuredGridBase* Take(vtkDataObject* input, vtkAbstractVolumeMapper* mapper);

  /// Names the blocks that were left out; else empty.
  const std::string& GetLeftOut() const { return this->LeftOut; }

  /// Gives a mesh to the filter, which is to follow the mapper's scalars.
  static void Feed(
    vtkUnstructuredGridBase* mesh, vtkAbstractVolumeMapper* mapper, vtkConvexCells* cells);

  /// Of all blocks; not initialised where there is nothing.
  static void FindBounds(vtkDataObject* input, double bounds[6]);

private:
  struct Block
  {
    vtkDataSet* Data;
    std::string Name;
  };
  void ListBlocks(vtkDataObject* input);
  void LeaveOthersOut(vtkAbstractVolumeMapper* mapper);
  void Append();
  std::vector<vtkMTimeType> FindSources(vtkAbstractVolumeMapper* mapper) const;

  std::vector<Block> Blocks;
  std::string Scalars; // the name of the chosen array
  bool OnePerCell = false;
  std::string LeftOut;
  std::vector<vtkMTimeType> Sources;
  vtkSmartPointer<vtkUnstructuredGridBase> Grid;
};

#endif
