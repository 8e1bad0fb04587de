# cmake -DROOT=<top folder> -DSCRATCH=<folder> -P: the top folder is no project, and says which folder is.
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${ROOT}" -B "${SCRATCH}"
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
# CMake wraps long messages.
string(REGEX REPLACE "[ \n]+" " " output "${output}")
if(result EQUAL 0 OR NOT output MATCHES "cmake -S Module -B build")
  message(FATAL_ERROR "Configuring the top folder gave ${result}: ${output}")
endif()
