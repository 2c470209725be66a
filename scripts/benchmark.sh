#!/usr/bin/env bash
# Measures what accuracy costs, for Poinsot and for other people's solvers, and writes doc/accuracy_cost.md with its
# pictures and doc/torque_cost.md.
#
# Usage: scripts/benchmark.sh
#
# Installs the solvers that are missing. Takes about a quarter of an hour; run nothing else on the machine meanwhile.
# The build directory is build/, or $POINSOT_BUILD.
# Exit: 0; 1 when something could not be built, measured or written, or an accuracy: is not kept; 2 for bad use.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in
  '') ;;
  -h | --help) usage; exit 0 ;;
  *) bad_use "benchmark.sh: expected no argument, got '$1'" ;;
esac

"$root/scripts/setup.sh" --benchmarks --peers
build=${POINSOT_BUILD:-$build}
say "building"
build_package -DPOINSOT_BUILD_BENCHMARKS=ON work_precision_measure accuracy_choice method_costs torque_precision
programs=$build/devel/lib/poinsot

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

bad=0
say "accuracy: against an exhaustive search"
{
  cat << 'TEXT'
## `accuracy:` in a scene, against an exhaustive search

Thirty random bodies, T = 100 s, a state at every tick of 60 Hz. *Kept*: the error at 3000 random times, none
of them a tick, stays within the accuracy. The cost is that of computing the states, measured and divided by that of the cheapest method
and step that an exhaustive search over all methods and a ladder of steps finds. Steppers are judged down to 1e-11 rad.

TEXT
  "$programs/accuracy_choice" || bad=$?
} > "$work/accuracy.md"
cat "$work/accuracy.md"
[ "$bad" -le 1 ] || fail "benchmark.sh: accuracy_choice failed"

say "work and precision"
"$programs/work_precision" --document "$root/doc/accuracy_cost.md" --append "$work/accuracy.md"
echo "written: $root/doc/accuracy_cost.md"

say "under torques"
{
  cat << 'TEXT'
# What accuracy costs under torques

CPU time of one motion from 0 to 100 s, set-up included, under Poinsot's methods for torques and under Boost.odeint's steppers with a
right-hand side written for that torque, all in one run. For each side, the table has the cheapest method that keeps the error; this is
the worst of four end times, of the attitude [rad] and of Ω, relative to |Ω|. The truth is odeint's Fehlberg 7(8) in long double. Made by
`scripts/benchmark.sh`, or by `build/devel/lib/poinsot/torque_precision` alone.

TEXT
  "$programs/torque_precision" || bad=$?
} > "$work/torque_cost.md"
cat "$work/torque_cost.md"
[ "$bad" -le 1 ] || fail "benchmark.sh: torque_precision failed"
mv "$work/torque_cost.md" "$root/doc/torque_cost.md"
echo "written: $root/doc/torque_cost.md"
exit "$bad"
