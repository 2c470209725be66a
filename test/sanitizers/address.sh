#!/usr/bin/env bash
# The core's tests under the address and undefined-behaviour sanitizers, in a build of their own (build/sanitized).
# The last line reads "N passed, M failed"; a program is one test.
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../../scripts/common.sh"

# All of the core's tests but those that take minutes here: far times in thousands of bits, and the same rows again for
# older processors. And but test_allocation, which has a malloc of its own as the sanitizer has; test_rooms, which
# runs nothing of the core; test_reference, whose 1e10 steps are those of the other tests and would take half an hour.
# Left out of test_core are two that would take most of the time and run code that others run as well: the search for a step
# from 1e9 s downwards (stiffDampingIsHopelessForMethodsThatDoNotCut searches too), and a million steps in a row.
programs=(test_core test_closed_form_rows test_closed_form_properties test_hard_cases)
left_out='OlderProcessors*:*sample/others*:ClosedFormAnyInput*:*samplesAreSingleEvaluations*'
left_out+=':TorqueStepLimits.shortStepsAreSoundAndLongOnesHopeless:HardEffects.theQuaternionStaysUnitForAMillionSteps'

export build=$build/sanitized
build_package -DCATKIN_ENABLE_TESTING=ON -DPOINSOT_BUILD_PANEL=OFF -DPOINSOT_SANITIZE=address misuse "${programs[@]}"
# A sourced setup.bash puts the ordinary library before the programs' own RUNPATH; its allocator is not the sanitizer's.
export LD_LIBRARY_PATH=$build/devel/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export UBSAN_OPTIONS=print_stacktrace=1
# Property tests draw fewer cases: the full number has run without sanitizers.
export RC_PARAMS="seed=1758 max_success=400 noshrink=1"

source "$here/../checks.sh"
misuse=$build/devel/lib/poinsot/misuse
expect nothing_wrong 0 'nothing was caught' "$misuse" none
expect out_of_bounds_is_caught 1 'AddressSanitizer: heap-buffer-overflow' "$misuse" out_of_bounds
expect overflow_is_caught 1 'signed integer overflow' "$misuse" overflow
# They run side by side; what each said and its exit code are looked at afterwards.
for program in "${programs[@]}"; do
  (
    code=0
    "$build/devel/lib/poinsot/$program" \
      --gtest_filter="-$left_out" \
      > "$build/$program.said" 2>&1 < /dev/null || code=$?
    echo $code > "$build/$program.code"
  ) &
done
wait
said_by() { cat "$build/$1.said"; return "$(cat "$build/$1.code")"; }
for program in "${programs[@]}"; do
  expect "${program}_loads_the_sanitized_library" 0 "libpoinsot_core.so => $build/" ldd "$build/devel/lib/poinsot/$program"
  expect "$program" 0 '^\[  PASSED  \] [1-9][0-9]* test' said_by "$program"
done

end_checks
