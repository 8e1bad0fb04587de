# The package vtkcellprojection: one extension module per VTK module, and an __init__.py that re-exports their classes.
set(CELLPROJECTION_PYTHON_DESTINATION "lib/python3/dist-packages" CACHE STRING
  "Folder of the Python package in the build and install trees; `make pythonpath` prints the default")

# The first python3 on PATH need not be the one that VTK was wrapped for.
execute_process(COMMAND "${Python3_EXECUTABLE}" -c "import vtkmodules.vtkCommonCore"
  RESULT_VARIABLE python_without_vtk OUTPUT_QUIET ERROR_QUIET)
if(python_without_vtk)
  message(WARNING "${Python3_EXECUTABLE} cannot import VTK: set Python3_EXECUTABLE to the interpreter that can")
endif()

# TARGET must not be CellProjection::Python: the file name Python.h would be installed.
vtk_module_wrap_python(
  MODULES ${cellprojection_modules}
  TARGET CellProjection::PythonWrapped
  PYTHON_PACKAGE vtkcellprojection
  MODULE_DESTINATION "${CELLPROJECTION_PYTHON_DESTINATION}"
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/CellProjection"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  INSTALL_EXPORT CellProjectionPython
  BUILD_STATIC OFF
  INSTALL_HEADERS OFF
  WRAPPED_MODULES wrapped_modules)

set(extension_imports)
foreach(module IN LISTS wrapped_modules)
  get_target_property(library ${module} OUTPUT_NAME)
  # The library carries VTK's version suffix; the extension does not.
  string(REGEX REPLACE "-[0-9.]+$" "" library "${library}")
  string(APPEND extension_imports "from .${library} import *\n")
endforeach()
set(python_package "${CELLPROJECTION_PYTHON_DESTINATION}/vtkcellprojection")
configure_file(Python/__init__.py.in "${CMAKE_BINARY_DIR}/${python_package}/__init__.py" @ONLY)
install(FILES "${CMAKE_BINARY_DIR}/${python_package}/__init__.py"
  DESTINATION "${python_package}" COMPONENT python)
