#!/usr/bin/env bash
# The scripts as a user calls them: bad use, bad scenes, a strange python3 in front, a picture, and that a failing test
# is counted as one. The last line reads "N passed, M failed".
source "$(dirname "${BASH_SOURCE[0]}")/../../scripts/common.sh"
source "$(dirname "${BASH_SOURCE[0]}")/../checks.sh"

work=$(mktemp -d) || exit 1
trap '[ "$failed" -gt 0 ] || rm -rf "$work"' EXIT  # logs are there to be looked at
logs=$work/logs
mkdir "$logs"

demo=$root/scripts/demo.sh
expect "demo.sh --help" 0 'Usage: scripts/demo.sh' "$demo" --help
expect "test.sh --help" 0 'Usage: scripts/test.sh' "$root/scripts/test.sh" --help
expect "setup.sh --help" 0 'Usage: scripts/setup.sh' "$root/scripts/setup.sh" --help
says_nothing() {
  local said
  said=$("$@" 2>&1)
  printf '%s\n' "$said"
  [ -z "$said" ]
}
check "setup.sh finds nothing missing" says_nothing "$root/scripts/setup.sh"
expect "demo.sh: unknown option" 2 "unknown option '--headles'" "$demo" --headles
expect "demo.sh: option without its value" 2 '--duration needs a value' "$demo" --duration
expect "demo.sh: duration that is no number" 2 "--duration: expected a positive number of seconds, got 'soon'" "$demo" --duration soon
expect "demo.sh: duration zero" 2 "--duration: expected a positive number of seconds, got '0'" "$demo" --duration 0
expect "demo.sh: scene that does not exist" 2 "--scene: expected a scene file or one of .*dzhanibekov.*, got 'nosuch'" "$demo" --scene nosuch
expect "demo.sh: picture that cannot be written" 2 'cannot write /nowhere/shot.png' "$demo" --screenshot /nowhere/shot.png
compare=$root/scripts/compare.sh
expect "compare.sh --help" 0 'Usage: scripts/compare.sh' "$compare" --help
expect "compare.sh: mode that does not exist" 2 "--mode: expected equal_cost or equal_step, got 'equal_luck'" "$compare" --mode equal_luck
expect "compare.sh: sheet that is no PNG" 2 'expected a file that ends with .png, got .*sheet.jpg' "$compare" --out sheet.jpg
expect "compare.sh: unknown option" 2 "unknown option '--modes'" "$compare" --modes
film=$root/scripts/film.sh
expect "film.sh --help" 0 'Usage: scripts/film.sh' "$film" --help
expect "film.sh: no scene" 2 'expected a scene file or one of .*dzhanibekov.*, got none' "$film"
expect "film.sh: scene that does not exist" 2 "expected a scene file or one of .*dzhanibekov.*, got 'nosuch'" "$film" nosuch
expect "film.sh: two scenes" 2 "expected one scene, got 'phone' and 'sphere'" "$film" phone sphere
expect "film.sh: unknown option" 2 "unknown option '--second'" "$film" phone --second 3
expect "film.sh: option without its value" 2 '--seconds needs a value' "$film" phone --seconds
expect "film.sh: seconds that are none" 2 "--seconds: expected a positive number below 10000, got '-3'" "$film" phone --seconds -3
expect "film.sh: speed zero" 2 "--speed: expected a positive number below 10000, got '0'" "$film" phone --speed 0
expect "film.sh: odd size" 2 "--size: expected WIDTHxHEIGHT in even numbers.*, got '641x480'" "$film" phone --size 641x480
expect "film.sh: picture of no kind" 2 "--picture: expected webp, gif or none, got 'png'" "$film" phone --picture png
expect "film.sh: view that does not exist" 2 '--view: expected one of Overview, Riding, Along L, got Behind' \
  "$film" phone --view Behind --out "$work/films"
expect "film.sh: directory that cannot be written" 2 'cannot write into /proc/films' "$film" phone --out /proc/films
expect "make_meshes.py: directory that is none" 2 'expected a directory, got /nowhere' "$root/scripts/make_meshes.py" /nowhere
expect "film.sh films two seconds" 0 "$work/films/phone.gif: " \
  "$film" phone --seconds 2 --fps 5 --size 640x360 --picture gif --picture-width 320 --out "$work/films"
# film_is FILE WIDTH HEIGHT SECONDS FRAMES: what it should be, and nearly every frame unlike the one before.
film_is() {
  local width height seconds frames unlike
  IFS=, read -r width height < <(ffprobe -v error -select_streams v:0 -show_entries stream=width,height -of csv=p=0 "$1")
  seconds=$(ffprobe -v error -show_entries format=duration -of csv=p=0 "$1")
  frames=$(ffmpeg -v error -i "$1" -f framemd5 - | grep -vc '^#')
  unlike=$(ffmpeg -v error -i "$1" -f framemd5 - | grep -v '^#' | awk '{print $NF}' | sort -u | wc -l)
  echo "$width x $height, $seconds s, $frames frames, $unlike of them unlike"
  awk "BEGIN {exit !($width == $2 && $height == $3 && $seconds > $4 - 0.3 && $seconds < $4 + 0.3 &&
                     $frames == $5 && $unlike >= 0.9 * $5)}"
}
expect "the film has its size, its length, and moves" 0 'frames' film_is "$work/films/phone.mp4" 640 360 2 10
expect "nothing else is left" 0 '^phone.gif phone.mp4 $' sh -c "ls -A '$work/films' | tr '\\n' ' '"
ffmpeg -v error -f lavfi -i color=gray:size=640x360:rate=5:duration=2 "$work/still.mp4"
expect "a film that stands still would be noticed" 1 'frames' film_is "$work/still.mp4" 640 360 2 10
printf 'bodies:\n  - name: b\n    inertia: [1, -2, 3]\n    angular_velocity: [0, 0, 1]\n' > "$work/bad.yaml"
expect "film.sh: bad scene" 2 'bad.yaml:3: .*inertia\[1\]: expected .*got -2' "$film" "$work/bad.yaml" --out "$work/films"
expect "demo.sh: bad scene" 2 'bad.yaml:3: .*inertia\[1\]: expected .*got -2' "$demo" --headless --scene "$work/bad.yaml"
printf 'bodies:\n  - name: b\n    inertia: [1, 2, 3]\n    angular_velocity: [0, 0.1, 1]\n    method: rk4\n    step: 5\n' > "$work/hopeless.yaml"
expect "demo.sh: hopeless step" 2 'hopeless.yaml:6: .*expected a step of at most .* or closed_form.*got rk4 with a step of 5 s' \
  "$demo" --headless --scene "$work/hopeless.yaml"

mkdir "$work/bin"
printf '#!/bin/sh\necho "not the python3 you want" >&2\nexit 42\n' > "$work/bin/python3"
cp "$work/bin/python3" "$work/bin/python"
chmod +x "$work/bin/"*
strange() { PATH="$work/bin:$PATH" "$@"; }
expect "demo.sh draws a picture, with a strange python3 first in PATH" 0 "the picture is in $work/shot.png" \
  strange "$demo" --headless --duration 5 --screenshot "$work/shot.png"
colours() {
  local image=$1
  # How many pixels are near the colour of each ellipsoid, lit from the front.
  local orange blue
  orange=$(convert "$image" -fuzz 12% -fill black +opaque 'rgb(235,153,12)' -fill white -opaque 'rgb(235,153,12)' -format '%[fx:mean*w*h]' info:)
  blue=$(convert "$image" -fuzz 12% -fill black +opaque 'rgb(26,104,200)' -fill white -opaque 'rgb(26,104,200)' -format '%[fx:mean*w*h]' info:)
  echo "orange $orange blue $blue pixels"
  awk "BEGIN {exit !($orange > 2000 && $blue > 2000)}"
}
expect "the picture holds both ellipsoids" 0 'orange' colours "$work/shot.png"
convert -size 1600x900 xc:gray20 "$work/empty.png"
expect "a picture without them would be noticed" 1 'orange' colours "$work/empty.png"

found() { bash -c "source '$build/devel/setup.bash' && rosrun poinsot propagate --help"; }
expect "rosrun finds the programs of a build in the package's own directory" 0 'Output columns: id,t,qw' found

# A second demo, on a display, in a shell that has sourced ROS, whose RViz crashes.
crash() {
  local listener demo_pid pid='' port code log=$work/second.log
  python3 -c 'import socket, time
s = socket.socket(); s.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1); s.bind(("127.0.0.1", 11311)); s.listen(); time.sleep(300)' &
  listener=$!
  sleep 1
  (unset ROS_IP ROS_HOSTNAME; ROS_MASTER_URI=http://localhost:11311 exec timeout 180 "$demo") > "$log" 2>&1 &
  demo_pid=$!
  for _ in $(seq 120); do
    port=$(sed -n 's|.*the ROS master of this demo is at http://127.0.0.1:||p' "$log")
    [ -z "$port" ] || pid=$(sed -n 's/.*process\[rviz-[0-9]*\]: started with pid \[\([0-9]*\)\].*/\1/p' "$build/demo-$port.log" 2> /dev/null)
    [ -z "$pid" ] || break
    sleep 0.5
  done
  sleep 5
  [ -z "$pid" ] || kill -SEGV "$pid"
  wait "$demo_pid"
  code=$?
  kill $listener 2> /dev/null
  [ -z "$port" ] || rm -f "$build/demo-$port.log"
  cat "$log"
  return $code
}
start_display 1600x900
expect "demo.sh beside another one takes a master of its own" 1 'port 11311 is taken: the ROS master of this demo is at http' crash
expect "demo.sh draws without anti-aliasing where software draws" 0 'without anti-aliasing' cat "$work/second.log"
expect "demo.sh says that RViz crashed" 0 'the launch ended early' cat "$work/second.log"
kill "$display_pid"

# What counts the results must see a failure, a crash and an empty run.
mkdir "$work/results" "$work/none"
printf '<testsuite><testcase classname="a" name="b" status="run"/></testsuite>' > "$work/results/good.xml"
count() { /usr/bin/python3 "$root/test/tests.py" count "$1"; }
expect "a good result counts as passed" 0 '^1 passed, 0 failed$' count "$work/results"
printf '<testsuite><testcase classname="a" name="b"><failure message="broken"/></testcase></testsuite>' > "$work/results/bad.xml"
expect "a failure counts as failed" 1 '^1 passed, 1 failed$' count "$work/results"
printf '<testsuite><testcase' > "$work/results/bad.xml"
expect "a file that was cut off counts as failed" 1 '^1 passed, 1 failed$' count "$work/results"
expect "no result at all counts as failed" 1 '^0 passed, 1 failed$' count "$work/none"

# What turns the lines of a script into results must see a failure, a crash, a miscount and a script that checks nothing.
script_result() { /usr/bin/python3 "$root/test/script_result.py" "$work/script/script-s.xml" "$work/script/log" bash -c "$1"; }
mkdir "$work/script"
expect "a script that passes is a result that passes" 0 '1 passed' script_result 'echo "PASS  a"; echo "1 passed, 0 failed"'
expect "and counts as one" 0 '^1 passed, 0 failed$' count "$work/script"
expect "a check that fails is noticed" 1 '' script_result 'echo "FAIL  a"; echo "0 passed, 1 failed"; exit 1'
expect "and counted" 1 '^0 passed, 1 failed$' count "$work/script"
expect "a script that breaks off is noticed" 1 '' script_result 'echo "PASS  a"; kill -9 $$'
expect "and counted as a failure" 1 '^1 passed, 1 failed$' count "$work/script"
expect "a last line that counts something else is noticed" 1 '' script_result 'echo "PASS  a"; echo "2 passed, 0 failed"'
expect "an exit code that contradicts it is noticed" 1 '' script_result 'echo "PASS  a"; echo "1 passed, 0 failed"; exit 1'
expect "a script that checks nothing is noticed" 1 '' script_result 'echo "0 passed, 0 failed"'

# The choice of tests.
expect "test.sh --list names tests with their tier" 0 '^test_core +quick' "$root/scripts/test.sh" --list
expect "test.sh --only of nothing is refused" 2 "no test matches 'no_such_test'" "$root/scripts/test.sh" --only no_such_test

end_checks
