#!/bin/sh
# setup.sh [LIST]: installs the packages of LIST (packages.txt) that are missing; does nothing where all are there.
set -eu
list=${1:-$(dirname "$0")/packages.txt}
packages=$(sed 's/#.*//' "$list" | xargs)

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "setup: not a Debian or Ubuntu system; install what these packages hold, then cmake -S Module -B build:" >&2
  echo "  $packages" >&2
  exit 1
fi

missing=
for package in $packages; do
  status=$(dpkg-query -W -f '${db:Status-Status} ' "$package" 2>/dev/null || true)
  case " $status" in
    *" installed "*) ;;
    *) missing="$missing $package" ;;
  esac
done
if [ -z "$missing" ]; then
  echo "setup: every package of $list is installed"
  exit 0
fi

as_root=
if [ "$(id -u)" -ne 0 ]; then
  as_root=sudo
  if ! command -v sudo >/dev/null; then
    echo "setup: no sudo; as root: apt-get install$missing" >&2
    exit 1
  fi
fi
echo "setup: installing$missing"
$as_root apt-get update -q
# shellcheck disable=SC2086
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing
