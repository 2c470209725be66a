#!/usr/bin/env bash
# The node under ThreadSanitizer, while rostests control it, change its bodies and take hold of them, in a build of its
# own (build/thread_sanitized). The last line reads "N passed, M failed".
# "unexpected memory mapping" means that the system spreads addresses further than this sanitizer knows (vm.mmap_rnd_bits
# above 28): run it under `setarch -R`.
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../../scripts/common.sh"

rostests=(ros_control ros_changes ros_grip)

export build=$build/thread_sanitized
needs=("${rostests[@]/#/needs_}")
build_package -DCATKIN_ENABLE_TESTING=ON -DPOINSOT_BUILD_PANEL=OFF -DPOINSOT_SANITIZE=thread misuse "${needs[@]/%/.test}"
source "$here/../checks.sh"
stay_on_loopback "$(free_port)"
export ROS_HOME=${ROS_HOME:-$build/ros_home}

# Quoted, since the paths may hold a blank.
sanitizer="suppressions='$here/thread_suppressions.txt' exitcode=66 halt_on_error=0 history_size=4"
misuse=$build/devel/lib/poinsot/misuse
expect nothing_wrong 0 'nothing was caught' env TSAN_OPTIONS="$sanitizer" "$misuse" none
expect race_is_caught 66 'WARNING: ThreadSanitizer: data race' env TSAN_OPTIONS="$sanitizer" "$misuse" race

# rostest does not see how the node ends, so what the sanitizer wrote is read. Other processes, Python's, do not know it.
# reports FOLDER: prints what it wrote of the nodes; fails when there is a report.
reports() {
  cat "$1"/of.poinsot_node.* && ! grep -qE '(WARNING|ERROR|FATAL): ThreadSanitizer' "$1"/of.poinsot_node.*
}

for rostest in "${rostests[@]}"; do
  folder=$build/reports/$rostest
  rm -rf "$folder"
  mkdir -p "$folder"
  expect "$rostest" 0 '^100% tests passed, 0 tests failed out of 1$' \
    env TSAN_OPTIONS="$sanitizer log_path='$folder/of' log_exe_name=1 verbosity=1" \
    ctest --test-dir "$build" --output-on-failure -R "^_ctest_poinsot_rostest_test_${rostest}[.]test\$"
  # With verbosity=1 each process that is instrumented says so.
  expect "${rostest}_without_a_report" 0 'Running under ThreadSanitizer' reports "$folder"
done
end_checks
