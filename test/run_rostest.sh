#!/usr/bin/env bash
# Runs rostest, for cmake/poinsot_tests.cmake.  Usage: run_rostest.sh RESULTS_DIRECTORY ARGUMENT_OF_ROSTEST ...
# rostest tells a test where its result goes in a text that it splits at blanks: it gets a link without any.
# The environment is the one that catkin made, so scripts/common.sh has no part in it.
set -euo pipefail

[[ ${TMPDIR:-} != *[[:space:]]* ]] || unset TMPDIR
link=$(mktemp -d)
trap 'rm -rf "$link"' EXIT
mkdir -p "$1"
ln -s "$1" "$link/results"
shift
/usr/bin/python3 /usr/bin/rostest --results-base-dir="$link/results" "$@"
