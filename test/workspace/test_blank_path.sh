#!/usr/bin/env bash
# Everything works in a folder whose name has a blank: the package is copied into one, and so is what it writes.
# One line a check, the last line counts them; exit 1 when one fails, and then the copy stays for looking at.
source "$(dirname "${BASH_SOURCE[0]}")/../package_copy.sh"
source "$(dirname "${BASH_SOURCE[0]}")/../checks.sh"

place=$(mktemp -d --suffix=" blank" "${TMPDIR:-/tmp}/poinsot.XXXXXX") || exit 1
leave_user_behind "$place"
cd "$place" || exit 1
logs=$place/logs
mkdir "$logs"
copy="$place/my workspace/poinsot" TMPDIR="$place/temporary files"
mkdir "$TMPDIR"
export TMPDIR
unset DISPLAY

check "the package is copied" copy_package "$copy"
check "demo.sh builds it and draws a picture" \
  "$copy/scripts/demo.sh" --headless --duration 3 --screenshot "$place/a picture.png"
# What RViz shows of the scene has many colours, an empty screen hardly any.
picture_is_drawn() { [ "$(identify -format %k "$place/a picture.png")" -gt 1000 ]; }
check "the picture is there" picture_is_drawn
film() {
  "$copy/scripts/film.sh" dzhanibekov --seconds 1 --fps 5 --size 640x360 --picture none --out "$place/the films" &&
    [ -s "$place/the films/dzhanibekov.mp4" ]
}
check "film.sh films" film

# Programs, launch files (one asks compare_scene for its scene, one records), RViz on a virtual display, Python.
tests=(test_rooms test_propagate test_compare_scene test_simulate launch_files ros_control ros_record_and_replay
  rviz_rviz_shows__launch_demo rviz_rviz_shows__launch_compare)
pattern="^($(IFS='|'; echo "${tests[*]}"))(\\.test)?\$"
check "test.sh" "$copy/scripts/test.sh" --only "$pattern"
all_ran() {
  local name
  for name in "${tests[@]}"; do
    grep -qE "^$name(\\.test)?," "$copy/build/test_durations.csv" || { echo "$name did not run"; return 1; }
  done
}
check "each of the tests ran" all_ran
in_devel() {
  # shellcheck disable=SC2016
  bash -c 'setup=$0; enter() { source "$setup"; }; enter; exec "$@"' "$copy/build/devel/setup.bash" "$@"
}
check "rosrun" in_devel rosrun poinsot poinsot_node --check "$copy/scenes/dzhanibekov.yaml"
nothing_beside() {
  local found
  found=$(cd "$place" && find . -maxdepth 2 -not -path './home*' -not -path './logs*' -not -path './temporary files*' | sort)
  diff <(printf '%s\n' . './a picture.png' './my workspace' './my workspace/poinsot' './the films' \
    './the films/dzhanibekov.mp4') - <<< "$found"
}
check "nothing is written beside the package" nothing_beside
# Half of a path with a blank would name another place.
check "nothing is written to half of the path" [ ! -e "${place% blank}" ]

if [ "$failed" -eq 0 ]; then rm -rf "$place"; else echo "what was built, and its logs, are in $place"; fi
end_checks
