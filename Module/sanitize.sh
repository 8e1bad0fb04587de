#!/bin/sh
# The kernels of the Tiles engines and their tests with ThreadSanitizer, in build-sanitize-thread.
set -eu
cd "$(dirname "$0")/.."
folder=build-sanitize-thread
cmake -S Module -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=None -DCELLPROJECTION_SANITIZE=thread >/dev/null
cmake --build "$folder"
cd "$folder"
# TBB is not instrumented: the threads and locks of STDThread are what the sanitizer sees.
VTK_SMP_BACKEND_IN_USE=STDThread TSAN_OPTIONS="suppressions=../Module/sanitize-threads.txt" \
  ctest --output-on-failure --no-tests=error
