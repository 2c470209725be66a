#!/usr/bin/env bash
# Takes one picture of each scene in scenes/ on a virtual screen, by demo.launch, and writes it to doc/scenes/NAME.png.
#
# Usage: scripts/scene_pictures.sh [--out DIR] [--view NAME] [SCENE ...]
#   --out DIR   the directory for the pictures (default: doc/scenes)
#   --view NAME a saved view of rviz/demo.rviz (default: Overview; others: Riding, Along L)
#   SCENE       names of scenes in scenes/ (default: all)
#
# Exit: 0; 1 when something failed; 2 for bad use.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

out=$root/doc/scenes view=Overview scenes=()
while [ $# -gt 0 ]; do
  case "$1" in
    --out) [ $# -ge 2 ] || bad_use "scene_pictures.sh: $1 needs a value"; out=$2; shift 2 ;;
    --view) [ $# -ge 2 ] || bad_use "scene_pictures.sh: $1 needs a value"; view=$2; shift 2 ;;
    -h | --help) usage; exit 0 ;;
    -*) bad_use "scene_pictures.sh: unknown option '$1'; see scene_pictures.sh --help" ;;
    *) [ -f "$root/scenes/$1.yaml" ] || bad_use "scene_pictures.sh: expected one of $(scene_names | paste -sd' '), got '$1'"; scenes+=("$1"); shift ;;
  esac
done
named=${#scenes[@]}
[ "$named" -gt 0 ] || mapfile -t scenes < <(scene_names)
mkdir -p "$out"

# at SCENE: prints the simulation time at which its picture shows most [s].
at() {
  case "$1" in
    dzhanibekov) echo 7.9 ;;
    explorer1) echo 19 ;;
    gravity_gradient) echo 7 ;;
    heavy_top_sleeping) echo 21 ;;
    heavy_top_*) echo 12.6 ;;
    separatrix) echo 21.7 ;;
    symmetric_* | sphere | regimes | hundred) echo 5 ;;
    t_handle) echo 14.2 ;;
    phone) echo 1.2 ;;
    tennis_racket) echo 4.3 ;;
    thruster_despin) echo 14 ;;
    damped_tumble) echo 8 ;;
    tossed_book) echo 6 ;;
    wingnut) echo 21 ;;
    *) echo 12 ;;
  esac
}

"$root/scripts/setup.sh" --pictures
[ -n "${POINSOT_NO_BUILD:-}" ] || { say "building"; build_package demo; }
enter_devel
stay_on_loopback "$(free_port)"

launch_pid='' display_pid='' log=$build/scene_pictures.log raw=$(mktemp --suffix=.png)
config=$(mktemp --suffix=.rviz)
end_launch() {
  [ -n "$launch_pid" ] || return 0
  kill -INT "$launch_pid" 2> /dev/null || true
  wait "$launch_pid" 2> /dev/null || true
  launch_pid=
}
finish() {
  end_launch
  [ -z "$display_pid" ] || kill "$display_pid" 2> /dev/null || true
  rm -f "$raw" "$config"
}
trap finish EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
start_display 1600x900

# picture SCENE: takes its picture into $raw; returns 1 if RViz or the node ended early.
picture() {
  roslaunch poinsot demo.launch scene:="$1" rviz_config:="$config" rviz_args:=--fullscreen > "$log" 2>&1 &
  launch_pid=$!
  local up=0
  await_rviz "$launch_pid" || up=$?
  [ $up -ne 1 ] || return 1
  [ $up -eq 0 ] || { tail -n 20 "$log" >&2; fail "scene_pictures.sh: RViz does not start with $1; see $log"; }
  sleep 3  # until it has drawn the first messages
  kill -0 "$launch_pid" 2> /dev/null || return 1
  timeout 90 python3 "$root/scripts/show_until.py" "$(at "$1")" || return 1  # without a master, it would wait for ever
  sleep 2
  kill -0 "$launch_pid" 2> /dev/null || return 1
  import -window root "$raw"
}

for scene in "${scenes[@]}"; do
  say "$scene at t = $(at "$scene") s"
  if ! said=$(/usr/bin/python3 "$root/scripts/choose_view.py" "$root/rviz/demo.rviz" "$config" "$view" 1600x900 2>&1); then
    [ "$named" -eq 0 ] || bad_use "scene_pictures.sh: $scene: $said"
    say "$scene: $said"  # not every scene has every view
    continue
  fi
  # With software OpenGL, RViz itself crashes occasionally.
  for try in 1 2 3; do
    if picture "$scene"; then break; fi
    end_launch
    [ $try -lt 3 ] || { tail -n 20 "$log" >&2; fail "scene_pictures.sh: $scene: the launch ended early three times; see $log"; }
    say "$scene: the launch ended early; trying again"
  done
  convert "$raw" -resize 960x540 -strip -define png:compression-level=9 "PNG24:$out/$scene.png"
  end_launch
done
