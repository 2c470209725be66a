#!/usr/bin/env bash
# Takes pictures of compare.launch at several times, on a virtual display, and makes one sheet of them.
#
# Usage: scripts/compare.sh [--mode equal_cost|equal_step] [--out FILE.png]
#   --out FILE.png   the sheet (default: build/compare.png); the single pictures are beside it, FILE_t<s>.png
#
# Plays at three times real time. Exit: 0; 1 when something failed; 2 for bad use.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

mode=equal_cost out=$build/compare.png times=(3 30 60 90)
speed=3
while [ $# -gt 0 ]; do
  case "$1" in
    --mode | --out)
      [ $# -ge 2 ] || bad_use "compare.sh: $1 needs a value"
      case "$1" in
        --mode) mode=$2 ;;
        --out) out=$(realpath -m -- "$2") ;;
      esac
      shift 2 ;;
    -h | --help) usage; exit 0 ;;
    *) bad_use "compare.sh: unknown option '$1'; see compare.sh --help" ;;
  esac
done
case "$mode" in equal_cost | equal_step) ;; *) bad_use "compare.sh: --mode: expected equal_cost or equal_step, got '$mode'" ;; esac
[[ $out == *.png ]] || bad_use "compare.sh: --out: expected a file that ends with .png, got '$out'"
{ mkdir -p "$(dirname "$out")" && [ -w "$(dirname "$out")" ]; } 2> /dev/null || bad_use "compare.sh: cannot write $out"

"$root/scripts/setup.sh" --pictures
say "building"
build_package demo compare_scene
enter_devel
stay_on_loopback "$(free_port)"

launch_pid='' display_pid='' log=$build/compare.log work=$(mktemp -d)
finish() {
  if [ -n "$launch_pid" ]; then
    kill -INT "$launch_pid" 2> /dev/null || true
    wait "$launch_pid" 2> /dev/null || true
  fi
  [ -z "$display_pid" ] || kill "$display_pid" 2> /dev/null || true
  rm -rf "$work"
}
trap finish EXIT
start_display 1600x900
say "showing compare.launch, $mode"
roslaunch poinsot compare.launch mode:="$mode" rviz_args:=--fullscreen > "$log" 2>&1 &
launch_pid=$!
died() { tail -n 20 "$log" >&2; launch_pid=; fail "compare.sh: the launch ended early; its output is in $log"; }
up=0
await_rviz "$launch_pid" || up=$?
[ $up -ne 1 ] || died
[ $up -eq 0 ] || { tail -n 20 "$log" >&2; fail "compare.sh: RViz does not start; its output is in $log"; }
sleep 3
rostopic pub -1 /poinsot/speed std_msgs/Float64 -- "$speed" > "$work/pub" 2>&1 &
rosservice call /poinsot/reset > "$work/reset"

# now: prints the simulation time [s].
now() { timeout 10 rostopic echo -n 1 /closed_form/state/time 2> /dev/null | head -n 1; }
sheet=()
for t in "${times[@]}"; do
  until awk "BEGIN {exit !($(now) >= $t)}"; do
    kill -0 "$launch_pid" 2> /dev/null || died
    sleep 0.1
  done
  picture=${out%.png}_t$t.png
  import -window root "$work/one.png"
  convert "$work/one.png" -gravity north -font DejaVu-Sans -pointsize 26 -fill white -annotate +0+12 "t = $t s" "$picture"
  sheet+=("$picture")
done
montage -font DejaVu-Sans "${sheet[@]}" -tile 2x -geometry 1000x+4+4 -background black +dither -colors 256 "PNG8:$work/sheet.png"
mv "$work/sheet.png" "$out"
echo "the sheet is in $out"
