# cmake -P: installs the build into an empty folder, then configures, builds and runs a project that knows only that.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${result}")
  endif()
endfunction()

file(REMOVE_RECURSE "${SCRATCH}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${SCRATCH}/prefix" --config "${CONFIG}")
function(build_project source binary)
  run("${CMAKE_COMMAND}" -S "${source}" -B "${binary}" -G "${GENERATOR}"
    "-DCMAKE_PREFIX_PATH=${SCRATCH}/prefix" "-DCMAKE_CXX_COMPILER=${COMPILER}"
    "-DCMAKE_BUILD_TYPE=${CONFIG}" "-DVTK_DIR=${VTK_DIR}")
  run("${CMAKE_COMMAND}" --build "${binary}" --config "${CONFIG}")
endfunction()

build_project("${CONSUMER}" "${SCRATCH}/build")
run("${SCRATCH}/build/bin/CellProjectionConsumer")

# The C++ example is what the README shows.
build_project("${EXAMPLES}" "${SCRATCH}/examples")
run("${SCRATCH}/examples/01_render_a_file" "${MESH}" "${SCRATCH}/picture.png")
file(SIZE "${SCRATCH}/picture.png" size)
if(size LESS 5000)
  message(FATAL_ERROR "the example's picture has only ${size} bytes")
endif()
if(PYTHON)
  # What is installed must not lean on the build tree or on LD_LIBRARY_PATH.
  run("${CMAKE_COMMAND}" -E env --unset=LD_LIBRARY_PATH "PYTHONPATH=${SCRATCH}/prefix/${PYTHON_DESTINATION}"
    "${PYTHON}" "${PYTHON_TEST}")
endif()
