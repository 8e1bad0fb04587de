# How the tests compile where that is to be quick. Most of a test's own work is short; what takes long to run keeps what
# the type of the build says, without precompiled headers, which are for one of both alone.
if(CELLPROJECTION_TEST_OPTIONS)
  target_compile_options(CellProjectionTests PRIVATE ${CELLPROJECTION_TEST_OPTIONS})
  set_source_files_properties(BoxTree.cxx EdgeThrough.cxx RayCells.cxx RayOrder.cxx TestRayOrder.cxx ${bsp_xmpvo_sources} PROPERTIES
    COMPILE_OPTIONS "$<$<CONFIG:Release>:-O3>"
    SKIP_PRECOMPILE_HEADERS ON)
endif()
