#!/bin/sh
# inside.sh ROOT SOURCE DATA COMMAND...: runs COMMAND in ROOT with the source tree (and the data, where there are any)
# at their own paths. Called by enter.sh in a mount namespace.
set -eu
root=$1 source=$2 data=$3
shift 3
for folder in /proc /dev /sys; do
  mount --rbind "$folder" "$root$folder"
done
for folder in "$source" ${data:+"$data"}; do
  mkdir -p "$root$folder"
  mount --bind "$folder" "$root$folder"
done
# Nothing of the outside reaches the command but what it names here: no display above all.
exec chroot "$root" /usr/bin/env -i HOME=/root LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
  ${data:+"CELLPROJECTION_DATA=$data"} \
  ${VTK_DEFAULT_OPENGL_WINDOW:+"VTK_DEFAULT_OPENGL_WINDOW=$VTK_DEFAULT_OPENGL_WINDOW"} \
  sh -c 'cd "$1" && shift && exec "$@"' sh "$source" "$@"
