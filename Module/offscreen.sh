#!/bin/sh
# Runs a command with a display: the one there is, else a virtual one.
# VTK_DEFAULT_OPENGL_WINDOW (VTK 9.4 and newer) names a window class that needs none.
if [ -n "${DISPLAY:-}${VTK_DEFAULT_OPENGL_WINDOW:-}" ]; then
  exec "$@"
fi
if ! command -v xvfb-run >/dev/null; then
  echo "offscreen: no DISPLAY and no xvfb-run; run Module/setup.sh" >&2
  exit 1
fi
# Without -noreset the server forgets its state with its last client, and the next window of a script dies.
exec xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$@"
