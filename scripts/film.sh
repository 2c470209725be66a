#!/usr/bin/env bash
# Films a scene in RViz, full screen, on a virtual display; writes SCENE.mp4 and a moving picture, SCENE.webp (or .gif).
#
# Usage: scripts/film.sh SCENE [--out DIR] [--seconds S] [--from T] [--speed R] [--view NAME] [--size WxH] [--fps N]
#                        [--picture webp|gif|none] [--picture-width W]
#   SCENE              a scene of scenes/, or the path of a scene file
#   --out DIR          the directory for the films (default: build/films)
#   --seconds S        length of the film (default: 10)
#   --from T           simulation time at the beginning [s] (default: 0)
#   --speed R          simulated seconds per second of film (default: 1)
#   --view NAME        a saved view of rviz/demo.rviz (default: Overview; others: Riding, Along L)
#   --size WxH         size of the mp4 in even numbers (default: 1280x720)
#   --fps N            frames a second (default: 25)
#   --picture KIND     kind of the moving picture beside it (default: webp)
#   --picture-width W  width of the moving picture (default: 800)
#
# From frame to frame the paused node advances by steps, so a film is even on a slow machine. With software OpenGL, a film of
# 10 s takes about two minutes.
# Exit: 0; 1 when something failed; 2 for bad use or a bad scene. A film that fails leaves no files.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

scene='' out=$root/build/films seconds=10 from=0 speed=1 view=Overview size=1280x720 fps=25 picture=webp picture_width=800
while [ $# -gt 0 ]; do
  case "$1" in
    --out | --seconds | --from | --speed | --view | --size | --fps | --picture | --picture-width)
      [ $# -ge 2 ] || bad_use "film.sh: $1 needs a value"
      case "$1" in
        --out) out=$2 ;;
        --seconds) seconds=$2 ;;
        --from) from=$2 ;;
        --speed) speed=$2 ;;
        --view) view=$2 ;;
        --size) size=$2 ;;
        --fps) fps=$2 ;;
        --picture) picture=$2 ;;
        --picture-width) picture_width=$2 ;;
      esac
      shift 2 ;;
    -h | --help) usage; exit 0 ;;
    -*) bad_use "film.sh: unknown option '$1'; see film.sh --help" ;;
    *) [ -z "$scene" ] || bad_use "film.sh: expected one scene, got '$scene' and '$1'"; scene=$1; shift ;;
  esac
done
[ -n "$scene" ] || bad_use "film.sh: expected a scene file or one of $(scene_names | paste -sd' '), got none"
# positive OPTION VALUE: refuses a value that is not a positive number below 10000.
positive() {
  { [[ $2 =~ ^[0-9]*\.?[0-9]+$ ]] && awk "BEGIN {exit !($2 > 0 && $2 < 1e4)}"; } ||
    bad_use "film.sh: $1: expected a positive number below 10000, got '$2'"
}
positive --seconds "$seconds"
positive --speed "$speed"
[[ $fps =~ ^[1-9][0-9]?$ ]] || bad_use "film.sh: --fps: expected a whole number from 1 to 99, got '$fps'"
[[ $from =~ ^-?[0-9]*\.?[0-9]+$ ]] || bad_use "film.sh: --from: expected a number of seconds, got '$from'"
[[ $size =~ ^[1-9][0-9]{1,2}[02468]x[1-9][0-9]{1,2}[02468]$|^[1-9][0-9][02468]x[1-9][0-9][02468]$ ]] ||
  bad_use "film.sh: --size: expected WIDTHxHEIGHT in even numbers, such as 1280x720, got '$size'"
[[ $picture_width =~ ^[1-9][0-9]{1,3}$ ]] || bad_use "film.sh: --picture-width: expected a number of pixels, got '$picture_width'"
case "$picture" in webp | gif | none) ;; *) bad_use "film.sh: --picture: expected webp, gif or none, got '$picture'" ;; esac
case "$scene" in
  */* | *.yaml) file=$(realpath -m -- "$scene") name=$(basename "$scene" .yaml) ;;
  *) file=$root/scenes/$scene.yaml name=$scene ;;
esac
config=$root/rviz/demo.rviz
[ -f "$file" ] || bad_use "film.sh: expected a scene file or one of $(scene_names | paste -sd' '), got '$scene'"
out=$(realpath -m -- "$out")
{ mkdir -p "$out" && [ -w "$out" ]; } 2> /dev/null || bad_use "film.sh: --out: cannot write into $out"

work=$(mktemp -d) core_pid='' launch_pid='' display_pid='' log=$root/build/film.log
finish() {
  for pid in $launch_pid $core_pid; do
    kill -INT "$pid" 2> /dev/null || true
    wait "$pid" 2> /dev/null || true
  done
  [ -z "$display_pid" ] || kill "$display_pid" 2> /dev/null || true
  rm -rf "$work"
}
trap finish EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
/usr/bin/python3 "$root/scripts/choose_view.py" "$config" "$work/view.rviz" "$view" "$size" 2> "$work/said" ||
  bad_use "film.sh: $(cat "$work/said")"

"$root/scripts/setup.sh" --pictures --films
[ -n "${POINSOT_NO_BUILD:-}" ] || { say "building"; build_package demo; }
enter_devel
"$build/devel/lib/poinsot/poinsot_node" --check "$file" > "$work/said" 2>&1 || { cat "$work/said" >&2; exit 2; }

mkdir -p "$(dirname "$log")" && : > "$log"
say "filming $name, $seconds s"
start_display "$size"
start_core "$work/core.log"
# In a fast film, a frame is several steps of the node, so that trails and paths are as fine as in real time.
steps=$(awk "BEGIN {n = 30 * $speed / $fps; printf \"%d\", n == int(n) ? n : n + 1}")
[ "$steps" -ge 1 ] || steps=1
rate=$(awk "BEGIN {printf \"%.9g\", $steps * $fps / $speed}")
roslaunch poinsot demo.launch scene_file:="$file" rate:="$rate" rviz_config:="$work/view.rviz" rviz_args:=--fullscreen >> "$log" 2>&1 &
launch_pid=$!
failed() { tail -n 20 "$log" >&2; fail "film.sh: $1; the output of the nodes is in $log"; }
up=0
await_rviz "$launch_pid" || up=$?
[ $up -ne 1 ] || failed "the launch ended early"
[ $up -eq 0 ] || failed "RViz does not start"
sleep 4  # until it has drawn the first messages
kill -0 "$launch_pid" 2> /dev/null || failed "RViz ended while it started"

frames=$(awk "BEGIN {printf \"%d\", $seconds * $fps + 0.5}")
skipped=$(awk "BEGIN {n = 3 * $fps / $speed; printf \"%d\", n < 150 ? n : 150}")
begin=$(awk "BEGIN {printf \"%.9g\", $from - $skipped * $speed / $fps}")
case "$from" in 0 | 0.0) skipped=0 begin=0 ;; esac  # no trail before the start
python3 "$root/scripts/film.py" "${size%x*}" "${size#*x}" "$frames" "$skipped" "$begin" "$steps" 2>> "$log" |
  ffmpeg -loglevel error -y -f rawvideo -pix_fmt bgr0 -video_size "$size" -framerate "$fps" -i pipe:0 \
    -c:v libx264 -preset slow -crf 20 -pix_fmt yuv420p -movflags +faststart "$work/film.mp4" 2>> "$log" ||
  failed "no film could be taken"
# At the rate of the film, or a whole fraction of it: frames left out irregularly would make it jerk.
picture_fps=$fps
for part in 2 3 4 5 6 7 8 9; do
  [ "$picture_fps" -gt 25 ] || break
  [ $((fps % part)) -ne 0 ] || picture_fps=$((fps / part))
done
case "$picture" in
  webp) ffmpeg -loglevel error -y -i "$work/film.mp4" -vf "fps=$picture_fps,scale=$picture_width:-2:flags=lanczos" -c:v libwebp_anim \
    -quality 75 -compression_level 4 -loop 0 -an "$work/film.webp" 2>> "$log" || failed "no moving picture could be made" ;;
  gif) ffmpeg -loglevel error -y -i "$work/film.mp4" -filter_complex \
    "fps=$picture_fps,scale=$picture_width:-2:flags=lanczos,split[a][b];[a]palettegen=max_colors=160[p];[b][p]paletteuse=dither=bayer:bayer_scale=4:diff_mode=rectangle" \
    "$work/film.gif" 2>> "$log" || failed "no moving picture could be made" ;;
esac
for kind in mp4 webp gif; do
  [ -f "$work/film.$kind" ] || continue
  cp "$work/film.$kind" "$out/.$name.$kind.part"
  mv "$out/.$name.$kind.part" "$out/$name.$kind"
  echo "$out/$name.$kind: $(stat -c %s "$out/$name.$kind") bytes"
done
