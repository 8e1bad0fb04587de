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
  printf '%s\n' "$2" | sed "s/^/checks: $1: /" >&2
  failed=1
}

# A process for all files, not one for each. 123: it found nothing.
on()
{
  list=$1
  shift
  printf '%s\n' "$list" | LC_ALL=C xargs -d '\n' "$@" || [ $? -eq 123 ] || echo "could not be checked"
}

IFS='
'
present=$(for file in $files; do [ ! -f "$file" ] || printf '%s\n' "$file"; done)
sources=$(printf '%s\n' "$present" |
  grep -E '\.(glsl|cxx|h|py|cmake|in|sh|xml)$|CMakeLists\.txt$|vtk\.module$|^Makefile$|^\.ci/')
long=$(on "$sources" awk \
  '{ limit = FILENAME ~ /\.glsl$/ ? 60 : 400 } FNR == limit { print FILENAME " has " limit " lines or more" }')
[ -z "$long" ] || complain "too long" "$long"
foreign=$(on "$sources" grep -Hn '[^[:print:][:space:]]')
[ -z "$foreign" ] || complain "not ASCII" "$foreign"
folders=$(on "$present" grep -HInE '(^|[^A-Za-z0-9_.-])/(work|home|root)/')
[ -z "$folders" ] || complain "a folder of one machine" "$folders"
[ "$failed" -eq 0 ] && echo "checks: passed"
exit "$failed"
