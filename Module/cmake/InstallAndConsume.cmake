# cmake -P: installs the build into an empty folder, then configures, builds and runs a project that knows only that.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${result}")
  endif()
endfunction()

file(REMOVE_RECURSE "${SCRATCH}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${SCRATCH}/prefix" --config "${CONFIG}")
run("${CMAKE_COMMAND}" -S "${CONSUMER}" -B "${SCRATCH}/build" -G "${GENERATOR}"
  "-DCMAKE_PREFIX_PATH=${SCRATCH}/prefix" "-DCMAKE_CXX_COMPILER=${COMPILER}"
  "-DCMAKE_BUILD_TYPE=${CONFIG}" "-DVTK_DIR=${VTK_DIR}")
run("${CMAKE_COMMAND}" --build "${SCRATCH}/build" --config "${CONFIG}")
run("${SCRATCH}/build/bin/CellProjectionConsumer")
if(PYTHON)
  # What is installed must not lean on the build tree or on LD_LIBRARY_PATH.
  run("${CMAKE_COMMAND}" -E env --unset=LD_LIBRARY_PATH "PYTHONPATH=${SCRATCH}/prefix/${PYTHON_DESTINATION}"
    "${PYTHON}" "${PYTHON_TEST}")
endif()
