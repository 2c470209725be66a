#!/usr/bin/env bash
# clang++ compiles everything, tests and benchmarks too, without a warning and each file by itself, in a build of its own
# (build/clang). Nothing is optimized: that takes less time, and nothing is run. The last line reads "N passed, M failed".
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../../scripts/common.sh"

export build=$build/clang
mkdir -p "$build"
source "$here/../checks.sh"

# built TARGET...: a subshell, since build_package ends the shell when the build fails.
built() (
  build_package -DCMAKE_CXX_COMPILER=clang++ -DCATKIN_ENABLE_TESTING=ON -DPOINSOT_BUILD_PANEL=ON \
    -DPOINSOT_BUILD_BENCHMARKS=ON -DPOINSOT_JOIN_FILES=OFF -DPOINSOT_WARNINGS_ARE_ERRORS=ON \
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 "$@"
  echo "built: $*"
)
expect everything_compiles 0 '^built' built all tests
expect a_warning_is_an_error 1 'error: unused variable .*-Werror,-Wunused-variable' built warned
end_checks
