#!/bin/sh
# Runs a command in a root of Debian's testing release, in this source tree, with no display.
# The root is made first where there is none: make_root.sh, beside this file.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
source=$(cd "$here/../.." && pwd)
root=${CELLPROJECTION_NEWEST_ROOT:-${XDG_CACHE_HOME:-$HOME/.cache}/cellprojection/debian-testing}
data=$(cd "${CELLPROJECTION_DATA:-$source/../shared/data}" 2>/dev/null && pwd || true)

# Mounts stay in a namespace of their own: nothing is left behind, whatever happens to the command.
if [ "$(id -u)" -eq 0 ] && unshare --mount true 2>/dev/null; then
  namespace="unshare --mount"
elif unshare --user --map-root-user --map-auto --mount true 2>/dev/null; then
  namespace="unshare --user --map-root-user --map-auto --mount"
else
  echo "NewestVTK: needs root, or user namespaces with a range in /etc/subuid and the package uidmap; neither is there" >&2
  exit 1
fi

$namespace "$here/make_root.sh" "$root"
exec $namespace "$here/inside.sh" "$root" "$source" "$data" "$@"
