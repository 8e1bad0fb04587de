/**
 * A polyhedron's list of faces as a closed surface, oriented consistently however its faces are
 * wound.
 *
 * Two faces that share an edge must run along it in opposite directions; from the first face on,
 * each is turned where it does not. Every edge must belong to exactly two faces.
 */
#ifndef PolyhedronSurface_h
#define PolyhedronSurface_h

#include "TetrahedralSplit.h"

#include <vector>

class PolyhedronSurface
{
public:
  enum class Defect
  {
    None,
    WrongList,    // of a wrong length, an id that does not exist, a face of fewer than 3 points
    Open,         // an edge without exactly two faces, or a surface of one side
    SeveralPieces // parts that share no edge
  };

  /**
   * `stream`: the number of faces, then of each face its number of points and its points, as
   * vtkUnstructuredGrid::GetFaceStream gives them. `canonical`: of each of the points of the mesh,
   * the id that it goes by, see CoincidentPoints; negative ones are kept. False for a WrongList.
   * A point that a face repeats in a row is taken once, a face that then has no area left out.
   */
  bool Read(const vtkIdType* stream, vtkIdType length, const vtkIdType* canonical,
    vtkIdType numberOfPoints);

  /** Orients the faces, all outward or all inward. */
  Defect Orient();

  /** Turns every face. */
  void Turn();

  /** How many faces are wound the other way than they were read. */
  int GetNumberOfTurnedFaces() const;

  /** Canonical ids by vertex, ascending. */
  const std::vector<vtkIdType>& GetIds() const { return this->Ids; }
  TetrahedralSplit::Solid GetSolid() const;

private:
  bool AddFace(
    const vtkIdType* points, vtkIdType count, const vtkIdType* canonical, vtkIdType numberOfPoints);
  void NumberVertices();
  bool FindMates();
  Defect TurnFromFirst();
  void TurnFace(int face);
  int Next(int position) const;

  std::vector<vtkIdType> Ids;
  std::vector<vtkIdType> Corners; // canonical ids by position
  std::vector<int> Offsets;       // by face, one more than there are
  std::vector<int> Vertices;      // by position
  std::vector<int> Faces;         // by position
  std::vector<int> Mates;         // by position: where the edge to the next one is used again
  std::vector<char> Turned;       // by face
};

#endif
