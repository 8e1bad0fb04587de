#ifndef ConvexCellBuffers_h
#define ConvexCellBuffers_h

#include "CellPlanes.h"
#include "ConvexCellFaces.h"
#include "FacePieces.h"
#include "TextureBuffer.h"
#include "vtkTimeStamp.h"

#include <array>
#include <functional>
#include <string>
#include <utility>

struct PreparedVolume;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

/**
 * @class ConvexCellBuffers
 * @brief Convex cells, their scalars and the transfer function, as arrays and on the GPU.
 *
 * What was made from it before is made again only where its source has changed.
 */
class ConvexCellBuffers
{
public:
  /// Is given the share of a preparation that is done, from 0 to 1.
  using Progress = std::function<void(double share)>;

  /// Faces and planes of the cells; needs no window.
  void Prepare(const PreparedVolume& prepared, const Progress& report);

  /// False, with the reason in GetFailure, where the arrays exceed the driver's limits. The context
  /// must be current.
  bool Upload(vtkOpenGLRenderWindow* window, const PreparedVolume& prepared);

  /// Binds what cp*.glsl read, and sets numberOfNodes and onePerCell.
  void Activate(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);

  const ConvexCellFaces& GetCells() const { return this->Cells; }
  const FacePieces& GetPieces() const { return this->Pieces; }
  const CellPlanes& GetPlanes() const { return this->Planes; }
  vtkMTimeType GetCellsTime() const { return this->CellsTime; }
  const std::string& GetFailure() const { return this->Failure; }

private:
  bool UploadCells(vtkOpenGLRenderWindow* window, const PreparedVolume& prepared);
  bool UploadScalars(vtkOpenGLRenderWindow* window, const PreparedVolume& prepared);
  bool UploadFunction(vtkOpenGLRenderWindow* window, const PreparedVolume& prepared);

  /// A buffer, and the sampler that reads it.
  struct Named
  {
    TextureBuffer Buffer;
    const char* Sampler;
    explicit Named(const char* sampler)
      : Sampler(sampler)
    {
    }
  };
  template <class Value>
  bool Put(
    vtkOpenGLRenderWindow* window, Named& named, const Value* values, size_t count, int components);
  std::array<Named*, 11> GetAll();

  ConvexCellFaces Cells;
  FacePieces Pieces;
  CellPlanes Planes;

  Named Headers{ "cellHeaders" };
  Named CornerIds{ "cornerIds" };
  Named Points{ "points" };
  Named PlaneTexels{ "cellPlanes" };
  Named PlanePieces{ "planePieces" };
  Named PieceCorners{ "pieceCorners" };
  Named PieceShapes{ "pieceShapes" };
  Named PieceScalars{ "pieceScalars" };
  Named CellValues{ "cellValues" };
  Named NodePositions{ "nodePositions" };
  Named NodeValues{ "nodeValues" };
  int NumberOfNodes = 0;
  bool OnePerCell = false;
  std::string Failure;

  vtkTimeStamp CellsTime;
  vtkTimeStamp CellsUploaded;
  vtkTimeStamp ScalarsUploaded;
  vtkTimeStamp FunctionUploaded;
};

#endif
