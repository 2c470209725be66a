#!/usr/bin/env bash
# Makes the reference of the public headers as web pages, build/doc/html/index.html.
#
# Usage: scripts/docs.sh
#
# Fails and prints the warnings of Doxygen when, for example, a name has no comment, or a comment names a parameter that
# does not exist or leaves one out (doc/Doxyfile). Exit: 0 without warnings, 1 otherwise, 2 for bad use.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in
  '') ;;
  -h | --help) usage; exit 0 ;;
  *) bad_use "docs.sh: expected no argument, got '$1'" ;;
esac
command -v doxygen > /dev/null || fail "docs.sh: doxygen is not installed; scripts/setup.sh --docs installs it"

cd "$root"
pages=$build/doc warnings=$build/doc/warnings.txt
rm -rf "$pages"
mkdir -p "$pages"
doxygen doc/Doxyfile || { cat "$warnings" >&2; fail "docs.sh: doxygen failed"; }
[ -s "$pages/html/index.html" ] || fail "docs.sh: expected $pages/html/index.html, but doxygen has not written it"
if [ -s "$warnings" ]; then
  cat "$warnings" >&2
  fail "docs.sh: expected no warnings, got $(grep -c ': \(warning\|error\): ' "$warnings")"
fi
echo "$pages/html/index.html"
