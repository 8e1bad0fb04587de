#ifndef CutSurfaces_h
#define CutSurfaces_h

#include "NearPlaneCut.h"
#include "PassTriangles.h"

#include <vector>

class FacePieces;
struct PreparedVolume;

/**
 * @class CutSurfaces
 * @brief The surfaces of the cells that the near plane cuts, without what is behind it, and closed.
 */
class CutSurfaces
{
public:
  /// `cut`: cells of `whole`, others are passed over. `nearPlane`: the positive side stays.
  void Build(const std::vector<unsigned int>& cut, const glm::vec4& nearPlane,
    const PassTriangles& whole, const FacePieces& pieces, const PreparedVolume& prepared);

  PassTriangles Passes;
  std::vector<NearPlaneCut::Triangle> Vertices; ///< Of the explicit triangles.
};

#endif
