#include "Convexification.h"

#include "CutSelection.h"
#include "Enclosure.h"
#include "ExteriorCut.h"
#include "ExteriorGeometry.h"
#include "ImaginaryCellAssembly.h"

#include <algorithm>
#include <cmath>

namespace
{
/** One run: the parts that are still to be cut, and the cells that came of them. */
class Convexifier
{
public:
  Convexifier(const CellComplex& mesh, const ConvexificationSettings& settings)
    : Settings(settings)
    , Geometry(mesh)
    , Hull(Geometry)
    , Box(Geometry)
    , Selection(Geometry, settings.NumberOfCandidateCuts)
    , Assembly(Geometry)
  {
  }

  ConvexificationResult Run();

private:
  void FindExterior();
  void Cut(const ExteriorPart& part);
  void Finish(const ExteriorPart& part);
  bool Report();

  const ConvexificationSettings& Settings;
  ExteriorGeometry Geometry;
  Enclosure Hull;
  Enclosure Box;
  CutSelection Selection;
  ImaginaryCellAssembly Assembly;
  std::vector<ExteriorPart> Open;
  double ExteriorVolume = 0.0;
  ConvexificationResult Result;
};

//------------------------------------------------------------------------------
void Convexifier::FindExterior()
{
  this->Hull.TakeConvexHull();
  if (this->Hull.IsFlat())
  {
    return;
  }
  if (!this->Settings.ConvexHull)
  {
    this->Box.TakeBox();
  }
  Enclosure& enclosure = this->Settings.ConvexHull ? this->Hull : this->Box;
  ExteriorPart exterior = enclosure.FindExterior();
  this->Result.EnclosureVolume = enclosure.GetVolume();
  this->ExteriorVolume = exterior.GetVolume(this->Geometry);
  this->Result.IsConvex = this->Settings.ConvexHull && exterior.Faces.empty();
  if (!exterior.Faces.empty())
  {
    this->Open.push_back(std::move(exterior));
  }
}

//------------------------------------------------------------------------------
ConvexificationResult Convexifier::Run()
{
  this->FindExterior();
  // Ends: no part is cut by a plane twice (CutSelection::CanCut), and planes are the mesh's own triangles'.
  while (!this->Open.empty())
  {
    ExteriorPart part = std::move(this->Open.back());
    this->Open.pop_back();
    std::vector<ExteriorPart> components = part.Separate(this->Geometry);
    if (components.size() > 1)
    {
      std::move(components.begin(), components.end(), std::back_inserter(this->Open));
      continue;
    }
    this->Cut(part);
    if (!this->Report())
    {
      this->Result = ConvexificationResult();
      this->Result.Aborted = true;
      return std::move(this->Result);
    }
  }
  this->Result.Cells = this->Assembly.Finish();
  const double filled = this->Result.ImaginaryVolume + this->Result.DiscardedVolume;
  if (this->Result.EnclosureVolume > 0.0)
  {
    this->Result.VolumeError =
      std::abs(filled - this->ExteriorVolume) / this->Result.EnclosureVolume;
  }
  return std::move(this->Result);
}

//------------------------------------------------------------------------------
void Convexifier::Cut(const ExteriorPart& part)
{
  const int plane = this->Selection.Choose(part);
  if (plane < 0)
  {
    this->Finish(part);
    return;
  }
  ExteriorPart below, above;
  ExteriorCut(this->Geometry, plane, this->Assembly.AddCut(plane)).Run(part, below, above);
  for (ExteriorPart* half : { &below, &above })
  {
    if (!half->Faces.empty())
    {
      this->Open.push_back(std::move(*half));
    }
  }
}

//------------------------------------------------------------------------------
void Convexifier::Finish(const ExteriorPart& part)
{
  const double volume = part.GetVolume(this->Geometry);
  if (!this->Settings.ConvexHull && this->Settings.DiscardOutsideHull && this->Hull.IsOutside(part))
  {
    this->Result.DiscardedVolume += volume;
    ++this->Result.NumberOfDiscardedCells;
    return;
  }
  this->Result.ImaginaryVolume += volume;
  this->Assembly.AddCell(part);
}

//------------------------------------------------------------------------------
bool Convexifier::Report()
{
  const double done = this->Result.ImaginaryVolume + this->Result.DiscardedVolume;
  return !this->Settings.Progress || !(this->ExteriorVolume > 0.0) ||
         this->Settings.Progress(std::min(1.0, std::max(0.0, done / this->ExteriorVolume)));
}
}

namespace Convexification
{
//------------------------------------------------------------------------------
ConvexificationResult Run(const CellComplex& mesh, const ConvexificationSettings& settings)
{
  return Convexifier(mesh, settings).Run();
}
}
