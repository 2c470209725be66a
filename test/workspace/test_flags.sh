#!/usr/bin/env bash
# Compiles a program that uses Poinsot's library with g++ and clang++ under the flags that users give, and demands the same
# output from all of them, bit by bit.
# Usage: test/workspace/test_flags.sh SETUP_BASH
#   SETUP_BASH   setup.bash of the devel or install space that has Poinsot
# One line a check, the last line counts them; exit 1 when one fails, and then the programs stay for looking at. What this
# processor cannot run is compiled all the same, and said to be skipped.
source "$(dirname "${BASH_SOURCE[0]}")/../../scripts/common.sh"
source "$(dirname "${BASH_SOURCE[0]}")/../checks.sh"

case "${1:-}" in
  -h | --help) usage; exit 0 ;;
esac
[ $# -eq 1 ] || bad_use "test_flags.sh: expected the path of a setup.bash, got $# words"
[ -f "$1" ] || bad_use "test_flags.sh: expected the path of a setup.bash, found no file '$1'"
setup=$(realpath "$1")

compilers=(g++ clang++)
# The last: Eigen's functions as symbols of the program, which the library must not take for its own.
flags=('-O0' '-O2' '-O2 -mavx2' '-O2 -mavx512f -mfma' '-O2 -march=native' '-O1 -fno-inline -mavx2 -mfma')

work=$(mktemp -d "${TMPDIR:-/tmp}/poinsot_flags.XXXXXX") || exit 1
first=
trap 'rm -rf "$work"; exit 130' INT TERM
# shellcheck disable=SC1090
enter_space() { set +u; source "$setup"; set -u; }  # a function: a sourced setup.bash takes the arguments that it sees
enter_space

# runs_here FLAGS: whether this processor has what they ask for.
runs_here() {
  local flag
  for flag in $1; do
    case $flag in
      -mavx2 | -mavx512f | -mfma) grep -qw "${flag#-m}" /proc/cpuinfo || return 1 ;;
    esac
  done
}

list=$(IFS=';'; echo "${flags[*]}")
for compiler in "${compilers[@]}"; do
  at=$work/$compiler
  configure() {
    cmake -S "$root/test/workspace/flags" -B "$at" -DPYTHON_EXECUTABLE=/usr/bin/python3 -DCMAKE_CXX_COMPILER="$compiler" \
      -DCMAKE_BUILD_TYPE= "-DFLAGS=$list"
  }
  if ! configure > "$at.configure.log" 2>&1; then
    bad "$compiler: the program is configured" < <(tail -n 12 "$at.configure.log")
    continue
  fi
  cmake --build "$at" --parallel "$(nproc)" -- -k > "$at.build.log" 2>&1 || true
  for i in "${!flags[@]}"; do
    what="$compiler ${flags[$i]}" program=$at/flags_$i
    if [ ! -x "$program" ]; then
      bad "$what: the program is built" < <(grep -E -A4 'error|warning' "$at.build.log" | head -n 12)
    elif ! runs_here "${flags[$i]}"; then
      echo "SKIP  $what: built, but this processor cannot run it"
    elif ! "$program" > "$program.txt" 2> "$program.err"; then
      bad "$what: the program runs" < <(tail -n 12 "$program.err")
    elif [ -z "$first" ]; then
      first=$program.txt
      # As many lines as a program that does what it says; and each exception has come across.
      if [ "$(wc -l < "$first")" -gt 1000 ] && grep -q '^NoConvergence: ' "$first" && grep -q '^invalid_argument: ' "$first"; then
        good "$what: the program runs"
      else
        bad "$what: the program prints states and what it caught" < <(tail -n 12 "$first")
      fi
    elif cmp -s "$first" "$program.txt"; then
      good "$what: the same bits"
    else
      bad "$what: the same bits as ${first#"$work"/}" < <(diff "$first" "$program.txt" | head -n 12 | cut -c 1-200)
    fi
  done
done

if cmake --build "$work/g++" --parallel "$(nproc)" --target headers > "$work/headers.log" 2>&1; then
  good "each public header compiles by itself and needs no Boost"
else
  bad "each public header compiles by itself and needs no Boost" < <(grep -E -A4 'error' "$work/headers.log" | head -n 12)
fi

if [ "$failed" -eq 0 ]; then rm -rf "$work"; else echo "the programs and their output are in $work"; fi
end_checks
