#!/bin/sh
# make_root.sh ROOT: Debian's testing release with everything a build needs, once; 4 GB. Called by enter.sh.
set -eu
root=$1
here=$(dirname "$0")
if [ -f "$root.complete" ]; then
  exit 0
fi
if ! command -v mmdebstrap >/dev/null; then
  echo "NewestVTK: needs mmdebstrap; install the package of that name" >&2
  exit 1
fi

packages=$(sed 's/#.*//' "$here/../packages.txt" "$here/packages.txt" | xargs | tr ' ' ',')
mirror=$(apt-get indextargets --format '$(SITE) $(RELEASE)' 'Created-By: Packages' |
  awk '$1 ~ /\/debian\/?$/ { print $1; exit }')
mirror=${mirror:-http://deb.debian.org/debian}

# An earlier attempt may have stopped half-way.
rm -rf "$root"
mkdir -p "$(dirname "$root")"
settings=$root.apt.conf
apt-config dump Acquire | grep -v '^Acquire::IndexTargets' >"$settings"
echo "NewestVTK: making a root of Debian testing in $root; minutes, once"
# Debian 12 is the second source, for OSMesa; every other package is the newer one.
if ! mmdebstrap --mode=root --variant=apt --aptopt="$settings" --include="$packages" forky "$root" \
  "deb $mirror forky main" "deb $mirror bookworm main" >"$root.log" 2>&1; then
  tail -n 20 "$root.log" >&2
  echo "NewestVTK: no root was made; the whole log is $root.log" >&2
  exit 1
fi
touch "$root.complete"
