#include "TetGenRun.h"

#include <tetgen.h>

#include <new>

namespace
{
constexpr int OutOfMemory = 1;
constexpr int InvalidInput = 10;

// TetGen aborts the process where the points lie in a plane along the axes.
bool HasExtent(const tetgenio& in)
{
  bool differs[3] = { false, false, false };
  for (int i = 3; i < 3 * in.numberofpoints; ++i)
  {
    differs[i % 3] = differs[i % 3] || in.pointlist[i] != in.pointlist[i % 3];
  }
  return differs[0] && differs[1] && differs[2];
}

#ifdef TETGEN_FREES_BEFORE_THROW
void MeshBoundary(tetgenmesh& mesh)
{
  clock_t time = 0;
  mesh.meshsurface();
  mesh.recoverboundary(time);
  mesh.carveholes();
  if (mesh.subvertstack->objects > 0)
  {
    mesh.suppresssteinerpoints();
  }
  mesh.recoverdelaunay();
}

void RunStages(tetgenmesh& mesh, tetgenbehavior& behavior, tetgenio& in, tetgenio& out)
{
  clock_t time = 0;
  mesh.b = &behavior;
  mesh.in = &in;
  mesh.initializepools();
  mesh.transfernodes();
  exactinit(behavior.verbose, behavior.noexact, behavior.nostaticfilter, mesh.xmax - mesh.xmin,
    mesh.ymax - mesh.ymin, mesh.zmax - mesh.zmin);
  mesh.incrementaldelaunay(time);
  if (behavior.plc)
  {
    MeshBoundary(mesh);
  }
  if (behavior.quality)
  {
    mesh.delaunayrefinement();
  }
  if (behavior.plc && behavior.optlevel > 0)
  {
    mesh.optimizemesh();
  }
  mesh.outnodes(&out);
  mesh.outelements(&out);
}

void Tetrahedralize(tetgenbehavior& behavior, tetgenio& in, tetgenio& out)
{
  auto* mesh = new tetgenmesh;
  try
  {
    RunStages(*mesh, behavior, in, out);
  }
  catch (...)
  {
    ::operator delete(mesh);
    throw;
  }
  delete mesh;
}
#else
void Tetrahedralize(tetgenbehavior& behavior, tetgenio& in, tetgenio& out)
{
  tetrahedralize(&behavior, &in, &out);
}
#endif
}

namespace TetGenRun
{
//------------------------------------------------------------------------------
int Run(tetgenbehavior& behavior, tetgenio& in, tetgenio& out)
{
  if (in.numberofpoints < 4 || !HasExtent(in))
  {
    return InvalidInput;
  }
  try
  {
    Tetrahedralize(behavior, in, out);
  }
  catch (int code)
  {
    return code;
  }
  catch (const std::bad_alloc&)
  {
    return OutOfMemory;
  }
  return 0;
}
}
