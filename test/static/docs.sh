#!/usr/bin/env bash
# The reference of the public headers is made without a warning, and a comment that is wrong is noticed.
# The last line reads "N passed, M failed".
source "$(dirname "${BASH_SOURCE[0]}")/../package_copy.sh"
source "$(dirname "${BASH_SOURCE[0]}")/../checks.sh"

work=$(mktemp -d) || exit 1
trap '[ "$failed" -gt 0 ] || rm -rf "$work"' EXIT  # logs are there to be looked at

copy_package "$work/package"
docs=$work/package/scripts/docs.sh
expect "docs.sh makes the reference without a warning" 0 '/html/index.html$' "$docs"
printf '#pragma once\nnamespace poinsot {\n/** @param wrong is not what it is called. */\ndouble twice(double value);\n}\n' \
  > "$work/package/include/poinsot/core/broken.h"
expect "a comment that names a parameter wrongly is noticed" 1 "broken.h:3: .*argument 'wrong'" "$docs"

end_checks
