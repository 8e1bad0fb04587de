# Testing/Data pins each data file by its SHA-512. The files come from CELLPROJECTION_DATA or, where that folder does
# not exist, from VTK's public store by `cmake --build build --target CellProjectionFetchData`, into build/Data.
include(ExternalData)
set(ExternalData_SOURCE_ROOT "${cellprojection_root}/Testing")
set(ExternalData_BINARY_ROOT "${CMAKE_BINARY_DIR}")
set(ExternalData_URL_TEMPLATES
  "https://data.kitware.com/api/v1/file/hashsum/%(algo)/%(hash)/download"
  "https://www.vtk.org/files/ExternalData/%(algo)/%(hash)")

file(GLOB pins CONFIGURE_DEPENDS "${cellprojection_root}/Testing/Data/*.sha512")
foreach(pin IN LISTS pins)
  string(REGEX REPLACE "[.]sha512$" "" file "${pin}")
  ExternalData_Expand_Arguments(CellProjectionFetchData fetched "DATA{${file}}")
endforeach()
ExternalData_Add_Target(CellProjectionFetchData)
# A build must not need the network.
set_property(TARGET CellProjectionFetchData PROPERTY EXCLUDE_FROM_ALL ON)

# ctest reads this file before it lists the tests, so every test of every folder inherits the variable.
file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/TestEnvironment.cmake" @ONLY CONTENT [[
foreach(folder "@CELLPROJECTION_DATA@" "@CMAKE_BINARY_DIR@/Data")
  if("$ENV{CELLPROJECTION_DATA}" STREQUAL "" AND IS_DIRECTORY "${folder}")
    get_filename_component(folder "${folder}" ABSOLUTE)
    set(ENV{CELLPROJECTION_DATA} "${folder}")
  endif()
endforeach()
]])
set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${CMAKE_BINARY_DIR}/TestEnvironment.cmake")
