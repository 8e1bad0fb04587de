#!/bin/sh
# Style that needs no compiler: ASCII sources, short files, no path of one machine.
set -eu
cd "$(dirname "$0")/.."
if git rev-parse --git-dir >/dev/null 2>&1; then
  files=$(git ls-files --cached --others --exclude-standard)
else
  files=$(find . -type f -not -path './.git/*' -not -path './build*' -not -path './install/*' -not -name '*.pyc' | sed 's|^\./||')
fi
failed=0

complain()
{
  echo "checks: $1" >&2
  failed=1
}

IFS='
'
for file in $files; do
  [ -f "$file" ] || continue
  case $file in
    *.glsl) limit=60 ;;
    *.cxx | *.h | *.py | *.cmake | *.in | *.sh | *.xml | *CMakeLists.txt | *vtk.module | Makefile | .ci/*) limit=400 ;;
    *) limit=0 ;;
  esac
  if [ "$limit" -gt 0 ]; then
    if [ "$(wc -l <"$file")" -ge "$limit" ]; then
      complain "$file has $limit lines or more"
    fi
    if LC_ALL=C grep -n '[^[:print:][:space:]]' "$file" >&2; then
      complain "$file is not ASCII"
    fi
  fi
  if grep -InE '(^|[^A-Za-z0-9_.-])/(work|home|root)/' "$file" >&2; then
    complain "$file names a folder of one machine"
  fi
done
[ "$failed" -eq 0 ] && echo "checks: passed"
exit "$failed"
