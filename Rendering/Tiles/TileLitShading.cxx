// Compiled once for each instruction set that the machine may have.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "TileLitShading.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "TileLitShading.h"

#include "TileLitShader-inl.h"

HWY_BEFORE_NAMESPACE();
namespace CellProjectionTiles
{
namespace HWY_NAMESPACE
{
// NOLINTNEXTLINE: Highway's dispatch table names it.
TileShadeCount ShadeLit(const TileTask& task, const TileRectangle& tile, TileFragments& fragments,
  TileLitPieces (&remainders)[2])
{
  const TileLighting& lighting = *task.Lighting;
  if (!lighting.IsLit || lighting.HasOpacity || lighting.ColorKind != TileLighting::OwnColor)
  {
    return TileLitShader<true>(task, tile).Shade(MemoryLookUp(), fragments, remainders);
  }
  const TileLitShader<false> shader(task, tile);
  return WithLookUp(
    *task.Transfer, [&](auto values) { return shader.Shade(values, fragments, remainders); });
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace CellProjectionTiles
{
HWY_EXPORT(ShadeLit);
}

//------------------------------------------------------------------------------
TileShadeCount TileLitShading::Shade(const TileTask& task, const TileRectangle& tile,
  TileFragments& fragments, TileLitPieces (&remainders)[2])
{
  return HWY_DYNAMIC_DISPATCH(CellProjectionTiles::ShadeLit)(task, tile, fragments, remainders);
}
#endif
