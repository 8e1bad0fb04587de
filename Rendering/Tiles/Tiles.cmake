# The Tiles engines: added to the lists of the module.
list(APPEND sources
  Rendering/Tiles/TileBins.cxx
  Rendering/Tiles/TileCells.cxx
  Rendering/Tiles/TileExactCell.cxx
  Rendering/Tiles/TileLimits.cxx
  Rendering/Tiles/TileMesh.cxx
  Rendering/Tiles/TileNeighbours.cxx
  Rendering/Tiles/TileOrder.cxx
  Rendering/Tiles/TileProjection.cxx
  Rendering/Tiles/TileRepair.cxx
  Rendering/Tiles/TileScratchPool.cxx
  Rendering/Tiles/TileTransfer.cxx
  Rendering/Tiles/TileVertices.cxx
  Rendering/Tiles/TileView.cxx
  Rendering/Tiles/TilesEngine.cxx)

list(APPEND private_headers
  Rendering/Tiles/TileBins.h
  Rendering/Tiles/TileBuffer.h
  Rendering/Tiles/TileCells.h
  Rendering/Tiles/TileClipping-inl.h
  Rendering/Tiles/TileCompositing-inl.h
  Rendering/Tiles/TileCoverage-inl.h
  Rendering/Tiles/TileExactCell.h
  Rendering/Tiles/TileFragments.h
  Rendering/Tiles/TileGroup.h
  Rendering/Tiles/TileLimits.h
  Rendering/Tiles/TileMath-inl.h
  Rendering/Tiles/TileMesh.h
  Rendering/Tiles/TileNeighbours.h
  Rendering/Tiles/TileOrder.h
  Rendering/Tiles/TileProjection.h
  Rendering/Tiles/TileRecords-inl.h
  Rendering/Tiles/TileRepair.h
  Rendering/Tiles/TileScratch.h
  Rendering/Tiles/TileScratchPool.h
  Rendering/Tiles/TileSetup-inl.h
  Rendering/Tiles/TileShading-inl.h
  Rendering/Tiles/TileTask.h
  Rendering/Tiles/TileTransfer.h
  Rendering/Tiles/TileVertices.h
  Rendering/Tiles/TileView.h
  Rendering/Tiles/TilesEngine.h)
