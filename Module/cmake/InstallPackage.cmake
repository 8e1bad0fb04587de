# vtk_module_build installs headers, libraries, targets and module properties; find_package needs these two files more.
include(CMakePackageConfigHelpers)
set(package_destination "${CMAKE_INSTALL_LIBDIR}/cmake/CellProjection")
configure_package_config_file(cmake/cellprojection-config.cmake.in
  "${CMAKE_BINARY_DIR}/cellprojection-config.cmake"
  INSTALL_DESTINATION "${package_destination}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${CMAKE_BINARY_DIR}/cellprojection-config-version.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${CMAKE_BINARY_DIR}/cellprojection-config.cmake"
    "${CMAKE_BINARY_DIR}/cellprojection-config-version.cmake"
  DESTINATION "${package_destination}"
  COMPONENT development)
# VTK 9.1 installs the licences of third-party modules only.
install(FILES "${cellprojection_root}/LICENSE"
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/CellProjection"
  COMPONENT license)
if(TARGET CellProjection::TetGen)
  # Its notice on the AGPL.
  install(FILES "${cellprojection_root}/Module/TetGen/README.md"
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/CellProjectionTetGen"
    COMPONENT license)
endif()
