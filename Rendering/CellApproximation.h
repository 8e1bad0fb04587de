#ifndef CellApproximation_h
#define CellApproximation_h

#include "ApproximationTriangles.h"
#include "ProjectedTetrahedron.h"

#include <glm/vec4.hpp>

/**
 * @class CellApproximation
 * @brief How a projected tetrahedron becomes triangles. Abstract.
 */
class CellApproximation
{
public:
  virtual ~CellApproximation() = default;

  /// What Append gets of a point whose colour and extinction per world length are `value`.
  virtual glm::vec4 Classify(const glm::vec4& value) const { return value; }

  /// The triangles' last component is an extinction, and a fragment's opacity the exponential of
  /// that times the length between its depths; else it is an opacity.
  virtual bool IsExponential() const { return false; }

  /// `cell` has a class.
  virtual void Append(
    const ProjectedTetrahedron& cell, ApproximationTriangles& triangles) const = 0;
};

#endif
