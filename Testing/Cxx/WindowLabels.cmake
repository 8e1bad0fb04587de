# What another class of windows, and another OpenGL behind it, may break: contexts, depth, viewports, reading and
# writing pixels, textures, and the accuracy of every mapper by either engine.
foreach(test IN ITEMS
    TestAccuracy
    TestAccuracy-Raster
    TestCameraInside-Raster
    TestClippingPlanes
    TestClippingPlanes-Raster
    TestContexts
    TestIsoSurfaces
    TestIsoTriangles
    TestLitTable
    TestOpaqueChanges
    TestOpaqueDepth
    TestOpaqueGeometry
    TestOpaqueGeometry-Raster
    TestPictureScene
    TestPictureViewports
    TestPolyhedraAccuracy
    TestPolyhedraTiles
    TestPolyhedraViewports
    TestPolyhedraViewports-Raster
    TestRayCastAgreement
    TestSharedVolume
    TestShellAccuracy
    TestShellSettings
    TestShellTexture
    TestTableMemory
    TestThreePassView
    TestTilesAbort
    TestTilesInteraction
    TestTilesOcclusion
    TestUnsupported
    TestViewports
    TestViewports-Raster
    TestWindow
    TestWindowPixels)
  set_property(TEST CellProjection::CellProjectionCxx-${test} APPEND PROPERTY LABELS window)
endforeach()
