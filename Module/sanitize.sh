#!/bin/sh
# The kernels of the Tiles engines and their tests with ThreadSanitizer and with AddressSanitizer, in a folder of its
# own each.
set -eu
cd "$(dirname "$0")/.."
root=$PWD
# TBB is not instrumented: the threads and locks of STDThread are what the sanitizer sees.
export VTK_SMP_BACKEND_IN_USE=STDThread
export TSAN_OPTIONS="suppressions=$root/Module/sanitize-threads.txt"
# What VTK and the drivers keep to the end is not ours.
export ASAN_OPTIONS=detect_leaks=0

run()
{
  folder=$root/build-sanitize-$1
  cmake -S Module -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=None -DCELLPROJECTION_SANITIZE="$1" >/dev/null
  cmake --build "$folder" -j "$(nproc)"
  (cd "$folder" && ctest --output-on-failure --no-tests=error)
}

# Side by side: two files take most of each build, and a test most of its tests.
run thread &
thread=$!
run address &
address=$!
failed=0
wait "$thread" || failed=1
wait "$address" || failed=1
exit "$failed"
