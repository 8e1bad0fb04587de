#include "ApproximationTriangles.h"

//------------------------------------------------------------------------------
ApproximationTriangles::Rim ApproximationTriangles::MakeRim(
  const ProjectedTetrahedron& cell, float opacity)
{
  Rim rim;
  for (int i = 0; i < 4; ++i)
  {
    const ProjectedPoints::Point& corner = cell.GetCorner(i);
    rim[i] = MakeVertex(
      corner.GetScreen(), corner.Depth, 0.0, glm::vec4(glm::vec3(cell.GetValue(i)), opacity));
  }
  return rim;
}

//------------------------------------------------------------------------------
unsigned int ApproximationTriangles::AppendVertices(const Rim& rim)
{
  const auto first = static_cast<unsigned int>(this->Vertices.size());
  this->Vertices.insert(this->Vertices.end(), rim.begin(), rim.end());
  return first;
}

//------------------------------------------------------------------------------
void ApproximationTriangles::AppendFan(
  const ProjectedTetrahedron& cell, const Vertex& middle, const Rim& rim)
{
  const unsigned int first = this->AppendVertices(rim);
  this->Vertices.push_back(middle);
  std::array<std::array<int, 2>, 4> edges;
  const int count = cell.GetSilhouette(edges);
  for (int i = 0; i < count; ++i)
  {
    this->Indices.insert(
      this->Indices.end(), { first + 4, first + edges[i][0], first + edges[i][1] });
  }
}

//------------------------------------------------------------------------------
void ApproximationTriangles::AppendFaces(
  const ProjectedTetrahedron& cell, const Rim& corners, bool areFront)
{
  constexpr unsigned int Faces[4][3] = { { 1, 2, 3 }, { 0, 2, 3 }, { 0, 1, 3 }, { 0, 1, 2 } };
  const unsigned int first = this->AppendVertices(corners);
  for (int i = 0; i < 4; ++i)
  {
    if (areFront ? cell.IsFrontFace(i) : cell.IsBackFace(i))
    {
      const unsigned int(&face)[3] = Faces[i];
      this->Indices.insert(
        this->Indices.end(), { first + face[0], first + face[1], first + face[2] });
    }
  }
}
