#!/bin/sh
# test.sh [LABEL [OSMESA_LABEL]]: builds in a root of Debian's testing release, then runs the tests in a window of
# either class that needs no display. LABEL is core or long, OSMESA_LABEL the same or window, for OSMesa alone; without
# them every test runs. CMAKE_OPTIONS in the environment come after those here.
set -eu
cd "$(dirname "$0")/../.."
label=${1:-}
osmesa_label=${2:-$label}
Module/setup.sh Module/NewestVTK/host-packages.txt
inside=Module/NewestVTK/enter.sh
# What is deprecated in the newest VTK will be gone in the next: it fails the build here. And so does a file of the
# libraries that leaves an include to the precompiled headers, where CMAKE_OPTIONS does not ask for those.
options="-Wno-dev -DCELLPROJECTION_DEPRECATED_IS_ERROR=ON -DCELLPROJECTION_PRECOMPILE_MODULES=OFF \
-DCELLPROJECTION_BENCHMARKS=ON -DCELLPROJECTION_TEST_OPTIONS= -DCELLPROJECTION_FEWER_TARGETS=OFF ${CMAKE_OPTIONS:-}"
$inside make build BUILD=build-newest "CMAKE_OPTIONS=$options"
without=
for window in vtkEGLRenderWindow vtkOSOpenGLRenderWindow; do
  export VTK_DEFAULT_OPENGL_WINDOW=$window
  echo "test-newest: $window"
  $inside build-newest/bin/CellProjectionTests TestWindow
  $inside make test BUILD=build-newest "CMAKE_OPTIONS=$options" "LABEL=$label" "WITHOUT=$without"
  # What opens no window has been tested with the first class of windows.
  without=windowless
  label=$osmesa_label
done
