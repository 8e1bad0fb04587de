#include "OracleGradients.h"

//------------------------------------------------------------------------------
void OracleGradients::AddTetrahedron(const std::vector<OracleVertex>& vertices)
{
  OracleVector edges[3];
  double rises[3];
  for (int i = 0; i < 3; ++i)
  {
    edges[i] = vertices[i + 1].Position - vertices[0].Position;
    rises[i] = vertices[i + 1].Scalar - vertices[0].Scalar;
  }
  // The gradient solves edge . gradient = rise for the three edges (Cramer's rule).
  const double volume = edges[0].Dot(edges[1].Cross(edges[2]));
  const OracleVector gradient =
    (edges[1].Cross(edges[2]) * rises[0] + edges[2].Cross(edges[0]) * rises[1] +
      edges[0].Cross(edges[1]) * rises[2]) *
    (1.0 / volume);
  for (const OracleVertex& vertex : vertices)
  {
    Sum& sum = this->Sums[vertex.Id];
    sum.Gradient = sum.Gradient + gradient * std::abs(volume);
    sum.Volume += std::abs(volume);
  }
}

//------------------------------------------------------------------------------
OracleVector OracleGradients::GetGradient(long long id) const
{
  const auto found = this->Sums.find(id);
  return found == this->Sums.end() ? OracleVector()
                                   : found->second.Gradient * (1.0 / found->second.Volume);
}
