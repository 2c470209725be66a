#!/usr/bin/env bash
# Measures, side by side: the node's CPU time at 60 Hz for one body with nobody looking, against a bare tf broadcaster at
# 60 Hz; and how well the node keeps 1000 Hz.
#
# Usage: benchmark/node_load.sh [SECONDS]    (default 20 for each of the three pairs of runs)
source "$(dirname "${BASH_SOURCE[0]}")/../scripts/common.sh"
seconds=${1:-20}

build_package -DPOINSOT_BUILD_BENCHMARKS=ON demo bare_tf_broadcaster
enter_devel
start_graph

# cpu PID: CPU seconds spent so far.
cpu() { awk -v hz="$(getconf CLK_TCK)" '{print ($14 + $15) / hz}' "/proc/$1/stat"; }

program=$build/devel/lib/poinsot
for round in 1 2 3; do
  "$program/bare_tf_broadcaster" __name:=bare > /dev/null 2>&1 &
  bare=$!
  "$program/poinsot_node" __name:=load _scene_file:="$root/scenes/dzhanibekov.yaml" _rate:=60 > /dev/null 2>&1 &
  node=$!
  pids+=("$bare" "$node")
  sleep 3
  bare_before=$(cpu $bare) node_before=$(cpu $node)
  sleep "$seconds"
  awk -v b="$(cpu $bare)" -v b0="$bare_before" -v n="$(cpu $node)" -v n0="$node_before" -v s="$seconds" -v r=$round 'BEGIN {
    printf "round %d: bare tf broadcaster %.2f %% of a core, node %.2f %%, ratio %.2f\n", r, 100*(b-b0)/s, 100*(n-n0)/s, (n-n0)/(b-b0)}'
  kill -INT "$bare" "$node"
  wait "$bare" "$node" 2> /dev/null || true
done

"$program/poinsot_node" __name:=fast _scene_file:="$root/scenes/dzhanibekov.yaml" _rate:=1000 > /dev/null 2>&1 &
pids+=($!)
sleep 5
echo "at 1000 Hz, as the node reports on /diagnostics:"
timeout 20 rostopic echo -n 4 /diagnostics | grep -A1 -E '"?(rate \[Hz\]|jitter|lateness)' | grep -vE '^--' |
  sed 's/^ *\(-\)\{0,1\} *//' | paste -d' ' - - | tail -n 4
