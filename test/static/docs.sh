#!/usr/bin/env bash
# The reference of the public headers is made without a warning, and a comment that is wrong is noticed.
# The last line reads "N passed, M failed".
source "$(dirname "${BASH_SOURCE[0]}")/../package_copy.sh"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0

# expect WORDS CODE: runs docs.sh of the copy, which must exit with that code.
expect() {
  local got=0
  "$work/package/scripts/docs.sh" > "$work/said" 2>&1 || got=$?
  if [ "$got" -eq "$2" ]; then
    echo "PASS  $1"
    passed=$((passed + 1))
  else
    echo "FAIL  $1: exit $got, expected $2"
    tail -n 20 "$work/said" | sed 's/^/        /'
    failed=$((failed + 1))
  fi
}

copy_package "$work/package"
expect "docs.sh makes the reference without a warning" 0
printf '#pragma once\nnamespace poinsot {\n/** @param wrong is not what it is called. */\ndouble twice(double value);\n}\n' \
  > "$work/package/include/poinsot/core/broken.h"
expect "a comment that names a parameter wrongly is noticed" 1

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
