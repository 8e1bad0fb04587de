# VTK's and the standard library's headers, compiled once per program or library in place of once per file: a third of
# what a build takes. No header of this project: a change to one must not compile everything again.
set(cellprojection_standard_headers
  <algorithm> <array> <cmath> <functional> <iostream> <map> <numeric> <string> <unordered_map> <vector>)
set(cellprojection_vtk_headers
  <vtkCellArray.h>
  <vtkCellData.h>
  <vtkDoubleArray.h>
  <vtkFloatArray.h>
  <vtkIdTypeArray.h>
  <vtkMath.h>
  <vtkPointData.h>
  <vtkRenderer.h>
  <vtkRenderWindow.h>
  <vtkSMPTools.h>
  <vtkUnsignedCharArray.h>
  <vtkUnstructuredGrid.h>
  <vtkUnstructuredGridVolumeMapper.h>
  <vtkVolumeProperty.h>)

function(cellprojection_precompile_headers target)
  target_precompile_headers(${target} PRIVATE ${cellprojection_standard_headers} ${cellprojection_vtk_headers})
endfunction()

if(CELLPROJECTION_PRECOMPILE_MODULES AND TARGET CellProjection)
  cellprojection_precompile_headers(CellProjection)
  # A shader's text includes nothing.
  get_target_property(shader_texts CellProjection SOURCES)
  list(FILTER shader_texts INCLUDE REGEX "/cp[A-Za-z]+\\.cxx$")
  set_source_files_properties(${shader_texts}
    TARGET_DIRECTORY CellProjection
    PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
endif()
if(CELLPROJECTION_PRECOMPILE_TESTS AND TARGET CellProjectionTests)
  cellprojection_precompile_headers(CellProjectionTests)
endif()
if(CELLPROJECTION_PRECOMPILE_TESTS AND TARGET CellProjectionBenchmark)
  cellprojection_precompile_headers(CellProjectionBenchmark)
  # Both are built with the same flags.
  target_precompile_headers(CellProjectionReport REUSE_FROM CellProjectionBenchmark)
endif()
