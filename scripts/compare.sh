#!/usr/bin/env bash
# Shows two of the bodies of compare.launch, lie_euler and the closed form, at two times, and the energy of all of them, on one sheet.
#
# Usage: scripts/compare.sh [--mode equal_cost|equal_step] [--out FILE.png]
#   --out FILE.png   the sheet (default: build/compare.png); the single pictures are beside it, FILE_t<s>.png
#
# Takes the pictures on a virtual display. Exit: 0; 1 when something failed; 2 for bad use.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

mode=equal_cost out=$build/compare.png times=(3 60) duration=90
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

"$root/scripts/setup.sh" --pictures --plots
[ -n "${POINSOT_NO_BUILD:-}" ] || { say "building"; build_package demo compare_scene simulate; }
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
programs=$build/devel/lib/poinsot
failed() { tail -n 20 "$log" >&2; fail "compare.sh: $1; the output is in $log"; }
"$programs/compare_scene" --mode "$mode" "$root/scenes/dzhanibekov.yaml" > "$work/four.yaml" 2> "$log" || failed "there is no scene"
"$programs/simulate" "$work/four.yaml" --duration "$duration" --columns states,energy --csv "$work/four.csv" 2> "$log" ||
  failed "the energy could not be computed"
energy=$root/scripts/compare_energy.py
/usr/bin/python3 "$energy" scene "$work/four.yaml" "$work/two.yaml" lie_euler closed_form 2> "$log" || failed "there is no scene of two bodies"
/usr/bin/python3 "$energy" plot "$work/four.csv" "$work/energy.png" 2008 560 "${times[@]}" 2> "$log" || failed "the energy could not be drawn"

start_display 1600x900
say "showing two bodies of compare.launch, $mode"
roslaunch poinsot demo.launch scene_file:="$work/two.yaml" rviz_args:=--fullscreen >> "$log" 2>&1 &
launch_pid=$!
up=0
await_rviz "$launch_pid" || up=$?
[ $up -ne 1 ] || failed "the launch ended early"
[ $up -eq 0 ] || failed "RViz does not start"
sleep 3

sheet=()
for t in "${times[@]}"; do
  timeout $((t + 90)) python3 "$root/scripts/show_until.py" "$t" 2>> "$log" || failed "the node does not answer"
  sleep 2
  kill -0 "$launch_pid" 2> /dev/null || failed "the launch ended early"
  import -window root "$work/one.png"
  convert "$work/one.png" -gravity north -font DejaVu-Sans -pointsize 34 -fill white -annotate +0+12 "t = $t s" "$work/t$t.png"
  sheet+=("$work/t$t.png")
  rosservice call /poinsot/pause "data: false" > "$work/pause"
done
montage -font DejaVu-Sans "${sheet[@]}" -tile 2x -geometry 1000x+2+2 -background black "$work/pictures.png"
convert "$work/pictures.png" "$work/energy.png" -append -strip -define png:compression-level=9 "$work/sheet.png"
# Whole or not at all.
put() { cp "$1" "$2.part" && mv "$2.part" "$2"; }
for t in "${times[@]}"; do put "$work/t$t.png" "${out%.png}_t$t.png"; done
put "$work/sheet.png" "$out"
echo "the sheet is in $out"
