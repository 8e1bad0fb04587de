# TetGen as a library: the target TetGen::TetGen where tetgen.h and libtet are found (Debian: libtet1.5-dev).
find_path(TetGen_INCLUDE_DIR tetgen.h)
find_library(TetGen_LIBRARY tet)
mark_as_advanced(TetGen_INCLUDE_DIR TetGen_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(TetGen REQUIRED_VARS TetGen_LIBRARY TetGen_INCLUDE_DIR)
if(TetGen_FOUND AND NOT TARGET TetGen::TetGen)
  add_library(TetGen::TetGen UNKNOWN IMPORTED)
  # Releases before 1.6 free their memory in terminatetetgen(), then throw.
  file(STRINGS "${TetGen_INCLUDE_DIR}/tetgen.h" frees_before_throw REGEX "m->freememory\\(\\)")
  set(definitions TETLIBRARY)
  if(frees_before_throw)
    list(APPEND definitions TETGEN_FREES_BEFORE_THROW)
  endif()
  # Without TETLIBRARY its header is that of the program, which ends the process on an error.
  set_target_properties(TetGen::TetGen PROPERTIES
    IMPORTED_LOCATION "${TetGen_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${TetGen_INCLUDE_DIR}"
    INTERFACE_COMPILE_DEFINITIONS "${definitions}")
endif()
