# <build>/offscreen.sh runs a command with no display. From VTK 9.4 on the window class is chosen at run time.
set(CELLPROJECTION_HAS_WINDOW_CHOICE OFF)
if(VTK_VERSION VERSION_GREATER_EQUAL 9.4)
  set(CELLPROJECTION_HAS_WINDOW_CHOICE ON)
endif()
configure_file("${CMAKE_CURRENT_SOURCE_DIR}/offscreen.sh.in" "${CMAKE_BINARY_DIR}/offscreen.sh" @ONLY
  FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
