# VTK by named components: without them VTK 9.6 asks for every dependency it was built with.
set(cellprojection_vtk_components
  CommonCore
  CommonDataModel
  CommonExecutionModel
  CommonMath
  RenderingCore
  RenderingOpenGL2
  RenderingVolume)
set(build_components)
if(BUILD_TESTING)
  list(APPEND build_components
    FiltersCore
    FiltersGeneral
    FiltersSources
    IOImage
    IOLegacy
    IOParallel
    IOXML
    ImagingCore
    InteractionStyle
    RenderingVolumeOpenGL2
    TestingCore
    TestingRendering)
endif()
if(CELLPROJECTION_WRAP_PYTHON)
  list(APPEND build_components Python WrappingPythonCore)
endif()
find_package(VTK 9.1 REQUIRED
  COMPONENTS ${cellprojection_vtk_components} ${build_components}
  OPTIONAL_COMPONENTS glad glew IOExodus)
