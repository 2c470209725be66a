#!/usr/bin/env bash
# Builds the package and runs every test that it has.
#
# Usage: scripts/test.sh
#
# The last line reads "N passed, M failed". Exit: 0 when all passed, 1 otherwise.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in
  '') ;;
  -h | --help) usage; exit 0 ;;
  *) bad_use "test.sh: unknown word '$1'; it takes none" ;;
esac

"$root/scripts/setup.sh"

# Tests never meet a graph that is running, nor a display.
stay_on_loopback "$(free_port)"
unset DISPLAY
ROS_HOME=$(mktemp -d)
export ROS_HOME
trap 'rm -rf "$ROS_HOME"' EXIT

say "building the package and its tests"
results=$build/test_results
rm -rf "$results"
build_package all tests
enter_devel
stay_on_loopback "$(free_port)"

passed=0 failed=0 skipped=0

# count_xml: adds up what the test programs wrote, and names what failed.
count_xml() {
  local counts
  counts=$(python3 "$root/scripts/count_tests.py" "$results") || true
  printf '%s\n' "$counts" | head -n -1
  read -r p f s <<< "$(printf '%s\n' "$counts" | tail -n 1)"
  passed=$((passed + p)) failed=$((failed + f)) skipped=$((skipped + s))
}

# script NAME COMMAND...: a test that is a program of its own; it ends with "N passed, M failed".
script() {
  local name=$1 log=$build/$1.log
  shift
  say "$name"
  if "$@" > "$log" 2>&1; then local good=yes; else local good=no; fi
  grep -E '^(PASS|FAIL)|^        ' "$log" || true
  local line p f
  line=$(tail -n 1 "$log")
  if [[ $line =~ ^([0-9]+)\ passed,\ ([0-9]+)\ failed ]]; then
    p=${BASH_REMATCH[1]} f=${BASH_REMATCH[2]}
    [ $good = yes ] || [ "$f" -gt 0 ] || f=1
  else
    p=0 f=1
    tail -n 30 "$log"
  fi
  [ "$f" -eq 0 ] || echo "the whole output is in $log"
  passed=$((passed + p)) failed=$((failed + f))
}

say "gtest and rostest"
# One at a time: rostests measure time.
# catkin's run_tests succeeds even when tests fail: if it does not, it broke off.
if ! cmake --build "$build" --target run_tests > "$build/run_tests.log" 2>&1; then
  tail -n 20 "$build/run_tests.log"
  echo "FAIL  run_tests broke off; its output is in $build/run_tests.log"
  failed=$((failed + 1))
fi
count_xml

script sanitizers "$root/test/sanitizers/run.sh"
script mutations "$root/test/mutations/run.py"
script workspace "$root/test/workspace/test_workspace.sh"
script instructions "$root/test/instructions/test_instructions.py" "$build/devel/lib/poinsot/instruction_probe"
script work_precision "$root/test/scripts/test_work_precision.py" "$build/devel/lib/poinsot/work_precision"
script scenes "$root/test/scripts/test_scenes.py" "$build/devel/lib/poinsot"
script scripts "$root/test/scripts/test_scripts.sh"

say "result"
[ "$skipped" -eq 0 ] && echo "nothing was skipped" || echo "$skipped skipped, see above"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
