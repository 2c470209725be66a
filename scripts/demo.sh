#!/usr/bin/env bash
# Installs and builds what is missing, and shows a scene in RViz.
#
# Usage: scripts/demo.sh [--headless] [--scene NAME] [--duration S] [--screenshot FILE]
#   --headless         RViz on a virtual screen; the default if there is no DISPLAY
#   --scene NAME       a scene of scenes/, or the path of a scene file (default: dzhanibekov)
#   --duration S       ends S seconds after RViz has started (default: when RViz is closed; headless: 15)
#   --screenshot FILE  writes RViz's picture there as PNG, at the end (headless default: build/demo.png)
#
# Exit: 0; 1 when something failed; 2 for bad use or a bad scene.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

headless=no scene=dzhanibekov duration='' screenshot=''
while [ $# -gt 0 ]; do
  case "$1" in
    --headless) headless=yes; shift ;;
    --scene | --duration | --screenshot)
      [ $# -ge 2 ] || bad_use "demo.sh: $1 needs a value"
      case "$1" in
        --scene) scene=$2 ;;
        --duration) duration=$2 ;;
        --screenshot) screenshot=$2 ;;
      esac
      shift 2 ;;
    -h | --help) usage; exit 0 ;;
    *) bad_use "demo.sh: unknown option '$1'; see demo.sh --help" ;;
  esac
done
bad_duration() { bad_use "demo.sh: --duration: expected a positive number of seconds, got '$duration'"; }
[[ $duration =~ ^([0-9]+(\.[0-9]*)?)?$ ]] || bad_duration
[ -z "$duration" ] || awk "BEGIN {exit !($duration > 0)}" || bad_duration
if [ -n "$screenshot" ]; then
  screenshot=$(realpath -m -- "$screenshot")
  { [ -d "$(dirname "$screenshot")" ] && [ -w "$(dirname "$screenshot")" ] && [ ! -d "$screenshot" ]; } ||
    bad_use "demo.sh: --screenshot: cannot write $screenshot"
fi
[ -n "${DISPLAY:-}" ] || headless=yes

case "$scene" in
  */* | *.yaml) file=$(realpath -m -- "$scene") what=scene_file:=$file ;;
  *) file=$root/scenes/$scene.yaml what=scene:=$scene ;;
esac
[ -f "$file" ] || bad_use "demo.sh: --scene: expected a scene file or one of $(scene_names | paste -sd' '), got '$scene'"

packages=()
if [ $headless = yes ] || [ -n "$screenshot" ]; then packages=(--pictures); fi
"$root/scripts/setup.sh" "${packages[@]}"
say "building"
build_package demo
enter_devel
"$build/devel/lib/poinsot/poinsot_node" --check "$file" || exit 2

log=$build/demo.log
if [ -z "$user_graph" ]; then
  port=11311
  if [ $headless = yes ]; then
    port=$(free_port)
  elif port_taken $port; then  # by another demo: of two nodes with one name, ROS ends the first
    port=$(free_port) log=$build/demo-$port.log
    say "port 11311 is taken: the ROS master of this demo is at http://127.0.0.1:$port"
  fi
  stay_on_loopback "$port"
fi

rviz_args='' launch_pid='' display_pid='' partial=''
finish() {
  if [ -n "$launch_pid" ]; then
    kill -INT "$launch_pid" 2> /dev/null || true
    wait "$launch_pid" 2> /dev/null || true
  fi
  [ -z "$display_pid" ] || kill "$display_pid" 2> /dev/null || true
  rm -f "$partial"
}
trap finish EXIT
# Ctrl-C is the usual way to end a demo that has no duration.
if [ -z "$duration$screenshot" ] && [ $headless = no ]; then trap 'exit 0' INT; else trap 'exit 130' INT; fi
trap 'exit 143' TERM

if [ $headless = yes ]; then
  say "no display: RViz draws on a virtual one"
  start_display 1600x900
  rviz_args=--fullscreen
  duration=${duration:-15}
  screenshot=${screenshot:-$build/demo.png}
fi

# Without a graphics device, RViz spends most of its time on anti-aliasing. Pictures are taken with it all the same.
drawn_by_software() {
  [ -n "${LIBGL_ALWAYS_SOFTWARE:-}" ] || ! { compgen -G '/dev/dri/*' || compgen -G '/dev/nvidia[0-9]*'; } > /dev/null
}
if [ $headless = no ] && [ -z "$screenshot" ] && drawn_by_software; then
  echo "no graphics device: RViz draws by software, without anti-aliasing"
  rviz_args=--disable-anti-aliasing
fi

say "showing $scene"
roslaunch poinsot demo.launch "$what" rviz_args:="$rviz_args" > "$log" 2>&1 &
launch_pid=$!

died() { tail -n 20 "$log" >&2; launch_pid=; fail "demo.sh: the launch ended early; its output is in $log"; }

if [ -z "$duration" ] && [ -z "$screenshot" ]; then
  echo "close RViz or press Ctrl-C to end; the output of the nodes is in $log"
  wait "$launch_pid" || true
  # roslaunch exits 0 whatever its nodes did.
  if grep -aqE '\[poinsot-[0-9]+\] (process )?has died|process has died \[pid [0-9]+, exit code -?[1-9][0-9]*, cmd [^ ]*/rviz ' "$log"; then
    died
  fi
  launch_pid=
  exit 0
fi

up=0
await_rviz "$launch_pid" || up=$?
[ $up -ne 1 ] || died
[ $up -eq 0 ] || { tail -n 20 "$log" >&2; fail "demo.sh: RViz does not come up; the output of the launch is in $log"; }
sleep 3  # until it has drawn what it was sent
sleep "${duration:-5}"
kill -0 "$launch_pid" 2> /dev/null || died

if [ -n "$screenshot" ]; then
  partial=$(mktemp --suffix=.png)
  window=root
  [ $headless = yes ] || window=$(xwininfo -root -tree | awk '/ - RViz"/ {print $1; exit}')
  import -window "${window:-root}" "$partial" || fail "demo.sh: no picture could be taken"
  mv "$partial" "$screenshot"
  chmod 644 "$screenshot"
  echo "the picture is in $screenshot"
fi
