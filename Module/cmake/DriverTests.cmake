# Tests of the driver itself; those of the classes are in Testing/Cxx and Testing/Python.
function(cellprojection_add_driver_test name)
  add_test(NAME ${name} COMMAND ${ARGN})
  set_tests_properties(${name} PROPERTIES LABELS core SKIP_REGULAR_EXPRESSION "SKIPPED:")
endfunction()

set(scratch "${CMAKE_BINARY_DIR}/Testing/Temporary")

cellprojection_add_driver_test(RefusesTopFolder
  "${CMAKE_COMMAND}" "-DROOT=${cellprojection_root}" "-DSCRATCH=${scratch}/TopFolder"
  -P "${CMAKE_CURRENT_SOURCE_DIR}/cmake/CheckTopFolder.cmake")
cellprojection_add_driver_test(DataIsPinned
  "${CMAKE_COMMAND}" "-DPINS=${cellprojection_root}/Testing/Data"
  -P "${CMAKE_CURRENT_SOURCE_DIR}/cmake/CheckPinnedData.cmake")
cellprojection_add_driver_test(SourceStyle
  sh "${CMAKE_CURRENT_SOURCE_DIR}/checks.sh")

if(BUILD_SHARED_LIBS AND CMAKE_READELF AND CMAKE_NM)
  set(with_tetgen)
  if(TARGET CellProjection::TetGen)
    set(with_tetgen "-DWITH_TETGEN=$<TARGET_FILE:CellProjection::TetGen>")
  endif()
  cellprojection_add_driver_test(CoreWithoutTetGen
    "${CMAKE_COMMAND}" "-DCORE=$<TARGET_FILE:CellProjection::CellProjection>" ${with_tetgen}
    "-DREADELF=${CMAKE_READELF}" "-DNM=${CMAKE_NM}"
    -P "${CMAKE_CURRENT_SOURCE_DIR}/cmake/CheckCoreWithoutTetGen.cmake")
endif()

set(python_arguments)
if(CELLPROJECTION_WRAP_PYTHON)
  set(python_arguments
    "-DPYTHON=${Python3_EXECUTABLE}"
    "-DPYTHON_DESTINATION=${CELLPROJECTION_PYTHON_DESTINATION}"
    "-DPYTHON_TEST=${cellprojection_root}/Testing/Python/TestImport.py")
endif()
cellprojection_add_driver_test(InstallAndConsume
  "${CMAKE_COMMAND}" "-DBUILD=${CMAKE_BINARY_DIR}" "-DCONSUMER=${cellprojection_root}/Testing/Consumer"
  "-DEXAMPLES=${cellprojection_root}/Examples" "-DMESH=${cellprojection_root}/Testing/Data/cubes.vtu"
  "-DSCRATCH=${scratch}/InstallAndConsume" "-DGENERATOR=${CMAKE_GENERATOR}" "-DCOMPILER=${CMAKE_CXX_COMPILER}"
  "-DCONFIG=$<CONFIG>" "-DVTK_DIR=${VTK_DIR}" ${python_arguments}
  -P "${CMAKE_CURRENT_SOURCE_DIR}/cmake/InstallAndConsume.cmake")

# Testing/Python/<name>.py in the interpreter that VTK was wrapped for; its exit code 125 means skipped.
function(cellprojection_add_python_test name)
  add_test(NAME Python-${name}
    COMMAND "${Python3_EXECUTABLE}" "${cellprojection_root}/Testing/Python/${name}.py" ${ARGN}
    WORKING_DIRECTORY "${CMAKE_BINARY_DIR}/Testing/Temporary")
  set_tests_properties(Python-${name} PROPERTIES
    ENVIRONMENT "PYTHONPATH=${CMAKE_BINARY_DIR}/${CELLPROJECTION_PYTHON_DESTINATION};PYTHONDONTWRITEBYTECODE=1"
    LABELS core
    SKIP_RETURN_CODE 125)
endfunction()

if(CELLPROJECTION_WRAP_PYTHON)
  file(MAKE_DIRECTORY "${scratch}")
  add_subdirectory("${cellprojection_root}/Testing/Python" "${CMAKE_BINARY_DIR}/Testing/Python")
endif()
