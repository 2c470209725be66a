#!/usr/bin/env bash
# Installs and builds what the tests need, and runs them.
#
# Usage: scripts/test.sh [--all | --only PATTERN] [--list]
#   (no option)     the quick tests: what a change usually breaks
#   --all           all tests
#   --only PATTERN  the tests of either tier whose name matches the regular expression; installs the packages of --all
#   --list          prints name, tier and usual duration of these tests (by default, of all); runs none
#
# Prints the failures, the time of each stage and the ten slowest tests; all durations are in build/test_durations.csv.
# The last line reads "N passed, M failed". Exit: 0 when all passed, 1 otherwise, 2 for bad use.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

chosen=quick list=no
while [ $# -gt 0 ]; do
  case "$1" in
    --all) chosen=all; shift ;;
    --only)
      [ -n "${2:-}" ] || bad_use "test.sh: --only needs a regular expression"
      chosen=only:$2; shift 2 ;;
    --list) list=yes; shift ;;
    -h | --help) usage; exit 0 ;;
    *) bad_use "test.sh: unknown option '$1'; see test.sh --help" ;;
  esac
done

times=$(mktemp)
ROS_HOME=$(mktemp -d)
export ROS_HOME
trap 'rm -rf "$ROS_HOME" "$times"' EXIT
# stage NAME COMMAND...: runs the command and notes its duration.
stage() {
  local name=$1 begin=$EPOCHREALTIME
  shift
  "$@"
  awk -v name="$name" -v a="$begin" -v b="$EPOCHREALTIME" 'BEGIN {printf "%s,%.1f\n", name, b - a}' >> "$times"
}

packages=(--tests --pictures)
[ "$chosen" = quick ] || packages+=(--tests_long --films)
stage "installing packages" "$root/scripts/setup.sh" "${packages[@]}"
options=(-DCATKIN_ENABLE_TESTING=ON)
[ "$chosen" = quick ] || options+=(-DPOINSOT_BUILD_BENCHMARKS=ON)

# Tests use neither a running ROS graph nor a display.
stay_on_loopback "$(free_port)"
unset DISPLAY

tests() { /usr/bin/python3 "$root/test/tests.py" "$@"; }
stage configuring configure_package "${options[@]}"
if [ $list = yes ]; then
  case $chosen in
    quick | all) tests list "$build" ;;
    *) tests list "$build" "${chosen#only:}" ;;
  esac
  exit
fi
status=0
names=$(tests names "$build" "$chosen") || status=$?
[ $status -ne 2 ] || bad_use "test.sh: no test matches '${chosen#only:}'; --list prints their names"
[ $status -eq 0 ] || fail "test.sh: the tests cannot be listed"

say "building"
compile() {
  local targets
  mapfile -t targets < <(tests needs "$build" "$chosen")
  build_package "${targets[@]}"
}
stage building compile

say "testing"
rm -rf "$build/ctest.xml" "$build/test_results"
: > "$build/ctest.log"  # shown while it grows
run() {
  # Two slots a core: a test that computes takes two, one that mostly waits takes one (cmake/poinsot_tests.cmake).
  ctest --test-dir "$build" --parallel $((2 * $(nproc))) --output-junit "$build/ctest.xml" \
    -R "^($(paste -sd '|' <<< "${names//./[.]}"))\$" > "$build/ctest.log" 2>&1 &
  local pid=$!
  tail -n +1 --pid=$pid -f "$build/ctest.log" |
    sed -uE '/^ *[0-9]+\/[0-9]+ Test/!d; s/_ctest_poinsot_roslaunch-check_launch/launch_files/; s/_ctest_poinsot_(gtest_|rostest_test_)//' || true
  wait $pid || true
}
stage "running the tests" run
tests report "$build" "$times"
