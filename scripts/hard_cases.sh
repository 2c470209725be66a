#!/usr/bin/env bash
# Measures every method on every hard case, and writes doc/hard_cases.md.
#
# Usage: scripts/hard_cases.sh
#
# Takes a quarter of an hour, because it runs every method for 1e8 steps. The build directory is build/, or $POINSOT_BUILD.
# Exit: 0; 1 when a figure breaks a promise (the file then says where) or nothing could be measured; 2 for bad use.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in
  '') ;;
  -h | --help) usage; exit 0 ;;
  *) bad_use "hard_cases.sh: expected no argument, got '$1'" ;;
esac

"$root/scripts/setup.sh" --benchmarks
build=${POINSOT_BUILD:-$build}
build_package -DPOINSOT_BUILD_BENCHMARKS=ON hard_cases propagate poinsot_node
enter_devel
programs=$build/devel/lib/poinsot

work=$(mktemp -d)
target=$root/doc/hard_cases.md
trap 'rm -rf "$work" "$target.new"' EXIT

# scene NAME METHOD STEP ΩX ΩY ΩZ: writes a scene file of one body.
scene() {
  cat > "$work/$1.yaml" << SCENE
bodies:
  - {name: $1, inertia: [1, 2, 3], angular_velocity: [$4, $5, $6], method: $2, step: $3}
SCENE
}

# show COMMAND...: prints what a user sees, and the exit code.
show() {
  local code=0
  "$@" > "$work/shown" 2>&1 || code=$?
  sed 's/^/    /' "$work/shown"
  printf '    (exit %d)\n\n' "$code"
}

# check NAME: asks the node about a scene.
check() {
  printf '    $ poinsot_node --check %s.yaml\n' "$1"
  (cd "$work" && show "$programs/poinsot_node" --check "$1.yaml")
}

# row NAME METHOD STEP ΩX ΩY ΩZ: asks propagate for one row, t = 1 s.
row() {
  printf '    $ propagate --method %s --step %s < %s.csv\n' "$2" "$3" "$1"
  printf 'id,mu1,mu2,mu3,q0w,q0x,q0y,q0z,O01,O02,O03,t\n%s,1,2,3,1,0,0,0,%s,%s,%s,1\n' "$1" "$4" "$5" "$6" > "$work/$1.csv"
  show "$programs/propagate" --method "$2" --step "$3" < "$work/$1.csv"
}

programs_section() {
  cat << 'TEXT'

## What the programs say

A scene whose step is refused does not start; one whose step causes a warning starts, with the warning. `propagate` computes every row
and warns of each one that is not to be trusted; a state that is infinite or undefined is an error, whatever the step.

TEXT
  scene fast lie_euler 0.016667 5720 4767 6674
  check fast
  scene steady lie_euler 0.016667 0 0 10000
  check steady
  row fast lie_euler 0.016667 5720 4767 6674
  row fast rk4 0.016667 5720 4767 6674
}

head_section() {
  cat << 'TEXT'
# Hard cases

Made by `scripts/hard_cases.sh`; do not edit. Every method is run on every hard case. The test `test_hard_cases` checks the
same promises on the same cases, also for a method that is added later: what it must conserve follows from its row in the table
of methods.

TEXT
}

bad=0
{
  head_section
  "$programs/hard_cases" --long || bad=$?
  programs_section
} > "$target.new"
[ "$bad" -le 1 ] || fail "hard_cases.sh: the program hard_cases failed"
mv "$target.new" "$target"
echo "written: $target"
exit "$bad"
