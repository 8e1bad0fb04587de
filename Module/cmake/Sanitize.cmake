# In place of the modules: the kernels of the Tiles engines and their tests alone, instrumented, which takes
# minutes. VTK itself is not instrumented.
find_package(glm CONFIG REQUIRED)
find_package(hwy CONFIG REQUIRED)
find_package(VTK 9.1 REQUIRED COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel CommonMath FiltersCore FiltersGeneral FiltersSources IOLegacy
  RenderingCore RenderingOpenGL2 RenderingVolume)

include("${CMAKE_CURRENT_LIST_DIR}/PrecompiledHeaders.cmake")

set(classes)
set(sources)
set(private_headers)
include("${cellprojection_root}/Rendering/Tiles/Tiles.cmake")
# The adapter to the mappers.
list(REMOVE_ITEM sources Rendering/PolyhedraTiles.cxx)
# First what takes minutes alone: all else is compiled beside it.
set(longest_sources Rendering/Tiles/TileLitShading.cxx Rendering/Tiles/TileProjection.cxx)
list(REMOVE_ITEM sources ${longest_sources})
set(tiles_sources ${longest_sources} ${sources}
  Rendering/CellPlanes.cxx
  Rendering/ConvexCellFaces.cxx
  Rendering/FacePieces.cxx
  Rendering/TransferFunction.cxx
  Sorting/MortonOrder.cxx
  Sorting/RadixSort.cxx)

# What VTK's module system would write.
foreach(module IN ITEMS CellProjection CellProjectionOracle)
  string(TOUPPER "${module}" upper)
  file(WRITE "${CMAKE_BINARY_DIR}/include/vtk${module}Module.h" "#define VTK${upper}_EXPORT\n")
endforeach()

# A program of tests, with what they need of the product and of Testing/Cxx.
function(cellprojection_add_kernels name)
  cmake_parse_arguments(PARSE_ARGV 1 kernels "" "" "SOURCES;HELPERS;TESTS")
  list(TRANSFORM kernels_SOURCES PREPEND "${cellprojection_root}/")
  list(TRANSFORM kernels_HELPERS PREPEND "${cellprojection_root}/Testing/Cxx/")
  create_test_sourcelist(driver ${name}.cxx ${kernels_TESTS})
  list(GET driver 0 driver_main)
  list(TRANSFORM kernels_TESTS PREPEND "${cellprojection_root}/Testing/Cxx/" OUTPUT_VARIABLE test_sources)
  add_executable(${name} ${kernels_SOURCES} ${driver_main} ${test_sources} ${kernels_HELPERS})
  target_include_directories(${name} PRIVATE
    "${CMAKE_BINARY_DIR}/include"
    "${cellprojection_root}/Sorting"
    "${cellprojection_root}/Rendering"
    "${cellprojection_root}/Rendering/Tiles"
    "${cellprojection_root}/Testing/Cxx"
    "${cellprojection_root}/Testing/Oracle")
  # Two sets of vector instructions in place of all: less than half the time to compile.
  target_compile_definitions(${name} PRIVATE
    "HWY_DISABLED_TARGETS=(HWY_SSSE3|HWY_SSE4|HWY_AVX3|HWY_AVX3_DL)")
  target_compile_options(${name} PRIVATE
    -O1 -g1 -fno-omit-frame-pointer -fno-delete-null-pointer-checks
    "-fsanitize=${CELLPROJECTION_SANITIZE}" -fno-sanitize-recover=all)
  target_link_options(${name} PRIVATE "-fsanitize=${CELLPROJECTION_SANITIZE}")
  target_link_libraries(${name} PRIVATE ${VTK_LIBRARIES} hwy::hwy glm::glm)
  vtk_module_autoinit(TARGETS ${name} MODULES ${VTK_LIBRARIES})
  if(CELLPROJECTION_PRECOMPILE_TESTS)
    cellprojection_precompile_headers(${name})
  endif()
  foreach(test IN LISTS kernels_TESTS)
    get_filename_component(test_name "${test}" NAME_WE)
    add_test(NAME "Sanitized-${test_name}" COMMAND ${name} "${test_name}")
  endforeach()
endfunction()

# Optimised, the shading of light takes a minute and more to compile with ThreadSanitizer, seven with
# AddressSanitizer; as it is, seconds.
set_source_files_properties("${cellprojection_root}/Rendering/Tiles/TileLitShading.cxx" PROPERTIES
  COMPILE_OPTIONS "-O0"
  SKIP_PRECOMPILE_HEADERS ON)
cellprojection_add_kernels(CellProjectionTilesKernels
  SOURCES ${tiles_sources}
  HELPERS HexahedraArrays.cxx MeshLattice.cxx TestChecks.cxx TileArrays.cxx
  TESTS TestRadixSort.cxx TestTilesExtremes.cxx TestTilesKernels.cxx TestTilesMath.cxx)
