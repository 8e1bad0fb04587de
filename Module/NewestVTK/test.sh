#!/bin/sh
# test.sh [LABEL]: builds in a root of Debian's testing release, then runs the tests in a window of either class that
# needs no display. LABEL is core or long; without it every test runs.
set -eu
cd "$(dirname "$0")/../.."
label=${1:-}
Module/setup.sh Module/NewestVTK/host-packages.txt
inside=Module/NewestVTK/enter.sh
# What is deprecated in the newest VTK will be gone in the next: it fails the build here. And so does a file of the
# libraries that leaves an include to the precompiled headers.
options="-Wno-dev -DCELLPROJECTION_DEPRECATED_IS_ERROR=ON -DCELLPROJECTION_PRECOMPILE_MODULES=OFF"
$inside make build BUILD=build-newest "CMAKE_OPTIONS=$options"
without=
for window in vtkEGLRenderWindow vtkOSOpenGLRenderWindow; do
  export VTK_DEFAULT_OPENGL_WINDOW=$window
  echo "test-newest: $window"
  $inside build-newest/bin/CellProjectionTests TestWindow
  $inside make test BUILD=build-newest "CMAKE_OPTIONS=$options" "LABEL=$label" "WITHOUT=$without"
  # What opens no window has been tested with the first class of windows.
  without=windowless
done
