#!/usr/bin/env bash
# Counts the pictures a second that RViz draws of a scene under software OpenGL, beside an RViz that shows nothing.
#
# Usage: benchmark/frame_rate.sh SCENE [VIEW] [OPTION ...]
#   SCENE      a name in scenes/
#   VIEW       a name in rviz/, or the path of a .rviz file (default: demo)
#   OPTION ... of rviz_frame_rate: --seconds S, --rounds N, --rate HZ, --disable-anti-aliasing
source "$(dirname "${BASH_SOURCE[0]}")/../scripts/common.sh"
case "${1:-}" in
  '' | -h | --help) usage; exit 0 ;;
esac
scene=$1
shift
view=demo
if [ $# -gt 0 ] && [ "${1#-}" = "$1" ]; then
  view=$1
  shift
fi
[ -f "$root/scenes/$scene.yaml" ] || bad_use "frame_rate.sh: expected one of the scenes $(scene_names | paste -sd' '), got '$scene'"
case "$view" in
  */* | *.rviz) file=$(realpath -m -- "$view") ;;
  *) file=$root/rviz/$view.rviz ;;
esac
[ -f "$file" ] || bad_use "frame_rate.sh: expected a name in rviz/ or the path of a .rviz file, got '$view'"

build_package -DPOINSOT_BUILD_BENCHMARKS=ON demo rviz_frame_rate
enter_devel
start_graph
export HOME=$ROS_HOME XDG_RUNTIME_DIR=$ROS_HOME QT_QPA_PLATFORM=xcb
start_display 1600x900
pids+=("$display_pid")
program=$build/devel/lib/poinsot
"$program/poinsot_node" __name:=poinsot _scene_file:="$root/scenes/$scene.yaml" > /dev/null 2>&1 &
pids+=($!)
sleep 2
echo "$scene with ${file##*/}, $(nproc) cores"
"$program/rviz_frame_rate" "$file" "$@" 2> /dev/null | grep -E '^(round|ratio)'
