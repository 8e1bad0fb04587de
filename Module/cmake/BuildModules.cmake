# VTK builds a module in <binary dir>/<path of the module relative to CMAKE_SOURCE_DIR>. The module is the parent of
# this project, so that path would leave the build tree: both roots are moved for this call alone.
function(cellprojection_build_modules root)
  set(module_files "${root}/vtk.module")
  set(requested CellProjection::CellProjection)
  if(CELLPROJECTION_TETGEN AND TetGen_FOUND)
    list(APPEND module_files "${root}/Module/TetGen/vtk.module")
    list(APPEND requested CellProjection::TetGen)
  endif()
  if(BUILD_TESTING)
    list(APPEND module_files "${root}/Testing/Oracle/vtk.module")
    set(ExternalData_OBJECT_STORES "${CMAKE_BINARY_DIR}/ExternalData" CACHE PATH "Object stores of the test data")
    # Baselines lie in the tree as they are.
    set(ExternalData_SOURCE_ROOT "${root}/Testing")
    set(ExternalData_BINARY_ROOT "${CMAKE_BINARY_DIR}")
  endif()
  vtk_module_scan(
    MODULE_FILES ${module_files}
    REQUEST_MODULES ${requested}
    PROVIDES_MODULES modules
    WANT_BY_DEFAULT ON
    ENABLE_TESTS "${BUILD_TESTING}")
  set(top_binary_dir "${CMAKE_BINARY_DIR}")
  set(CMAKE_SOURCE_DIR "${root}")
  set(CMAKE_BINARY_DIR "${CMAKE_BINARY_DIR}/modules")
  vtk_module_build(
    MODULES ${modules}
    PACKAGE CellProjection
    INSTALL_EXPORT CellProjection
    CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/CellProjection"
    HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/cellprojection"
    VERSION "${PROJECT_VERSION}"
    SOVERSION "${PROJECT_VERSION_MAJOR}"
    TEST_DIRECTORY_NAME Testing
    TEST_DATA_TARGET CellProjectionData
    TEST_INPUT_DATA_DIRECTORY "${root}/Testing/Data"
    TEST_OUTPUT_DATA_DIRECTORY "${top_binary_dir}/Testing/Data"
    TEST_OUTPUT_DIRECTORY "${top_binary_dir}/Testing/Temporary")
  if(BUILD_TESTING)
    ExternalData_Add_Target(CellProjectionData)
  endif()
  set(cellprojection_modules "${modules}" PARENT_SCOPE)
endfunction()
