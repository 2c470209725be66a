#!/usr/bin/env bash
# Builds Poinsot as users do: in a catkin workspace beside another package, and runs it from the install space.
# Usage: test/workspace/test_workspace.sh [--full]
#   --full   all of Poinsot's own tests too, not only one of each kind
# One line a check, the last line counts them; exit 1 when one fails, and then the workspace stays for looking at.
source "$(dirname "${BASH_SOURCE[0]}")/../package_copy.sh"
source "$(dirname "${BASH_SOURCE[0]}")/../checks.sh"

full=no
case "${1:-}" in
  '') ;;
  --full) full=yes ;;
  -h | --help) usage; exit 0 ;;
  *) bad_use "test_workspace.sh: unknown option '$1'" ;;
esac

workspace=$(mktemp -d "${TMPDIR:-/tmp}/poinsot_workspace.XXXXXX") || exit 1
launch_pid=''
devel=$workspace/devel/setup.bash install=$workspace/install/setup.bash
mkdir "$workspace/src"
leave_user_behind "$workspace"
# catkin_make compiles with ccache where scripts/build.sh would.
[ -z "${CCACHE_DIR:-}" ] || export CMAKE_CXX_COMPILER_LAUNCHER=ccache
cd "$workspace" || exit 1
logs=$workspace/logs
mkdir "$logs"

stop_launch() {
  [ -n "$launch_pid" ] || return 0
  kill -INT "$launch_pid" 2> /dev/null || true
  wait "$launch_pid" 2> /dev/null || true
  launch_pid=''
}
trap stop_launch EXIT
trap 'exit 130' INT TERM

# in_space SETUP COMMAND...: with that space sourced and no other. A sourced setup.bash takes the arguments that it sees
# for its own: inside the function it sees none.
# shellcheck disable=SC2016
enter='setup=$0; enter() { source "$setup"; }; enter; exec "$@"'
in_space() { bash -c "$enter" "$@"; }
# -j: else catkin_make adds -l, and waits while the machine has other things to do.
make_workspace() { catkin_make -j"$(nproc)" -DPYTHON_EXECUTABLE=/usr/bin/python3 "$@"; }

fill_workspace() {
  copy_package "$workspace/src/poinsot" && cp -r "$root/test/workspace/neighbour" "$workspace/src/poinsot_neighbour"
}
check "the package is copied into a workspace" fill_workspace
check "catkin_make" make_workspace
[ "$failed" -eq 0 ] || { end_checks; exit 1; }
no_warning() { ! grep -B1 -A6 'CMake Warning' "$logs/catkin_make.log"; }
check "without a warning from CMake" no_warning
check "the neighbour runs" in_space "$devel" rosrun poinsot_neighbour spin

targets=(run_tests_poinsot_neighbour run_tests_poinsot_gtest_test_session
  run_tests_poinsot_rostest_test_ros_control.test)
[ "$full" = no ] || targets=(run_tests)
run_tests() { in_space "$devel" catkin_make -j"$(nproc)" -DPYTHON_EXECUTABLE=/usr/bin/python3 "${targets[@]}"; }
results() {
  ls build/test_results/poinsot_neighbour/*.xml build/test_results/poinsot/*.xml &&  # both packages' tests have run
    in_space "$devel" catkin_test_results build/test_results
}
check "catkin_make run_tests" run_tests
check "catkin_test_results" results

check "catkin_make install" make_workspace install
# What was built must not be needed any more: a path into it that was left in the install space would show.
mv "$workspace/devel" "$workspace/devel.gone"
mv "$workspace/src" "$workspace/src.gone"

share=$workspace/install/share/poinsot
is_installed() {
  local missing=0 file
  while read -r file; do
    [ -e "$file" ] || { echo "not installed: $file"; missing=1; }
  done < <(cd "$workspace/src.gone/poinsot" && {
    find launch rviz scenes -type f | sed "s|^|$share/|"
    find include/poinsot/core -type f | sed "s|^|$workspace/install/|"
    for message in msg/*.msg; do
      echo "$share/$message"
      echo "$workspace/install/include/poinsot/$(basename "$message" .msg).h"
    done
  })
  return $missing
}
names_nothing_of_the_build() {
  ! grep -rlE "$workspace/(devel|src|build)" "$workspace/install" --include='*.cmake' --include='*.pc' --include='*.launch' \
      --include='*.py' --include='*.sh' --include='*.rviz'
}
check "core's headers, messages, launch files, views and scenes are installed" is_installed
check "no installed file names the source or build space" names_nothing_of_the_build
check "rosrun poinsot propagate --help" in_space "$install" rosrun poinsot propagate --help
check_scene() {
  # shellcheck disable=SC2016
  in_space "$install" bash -c 'rosrun poinsot poinsot_node --check "$(rospack find poinsot)/scenes/dzhanibekov.yaml"'
}
check "rosrun poinsot poinsot_node --check scenes/dzhanibekov.yaml" check_scene
check "rosrun poinsot plot.py --help" in_space "$install" rosrun poinsot plot.py --help
check "rosrun poinsot check_bag --help" in_space "$install" rosrun poinsot check_bag --help
check "rosmsg show poinsot/BodyState" in_space "$install" rosmsg show poinsot/BodyState
check "the messages are there for Python" in_space "$install" python3 -c 'from poinsot.msg import BodyDescription, BodyState'

bash -c "$enter" "$install" roslaunch poinsot demo.launch rviz:=false > "$logs/demo.log" 2>&1 &
launch_pid=$!
first_message() {
  for _ in $(seq 8); do
    kill -0 "$launch_pid" || { cat "$logs/demo.log"; return 1; }
    in_space "$install" timeout 10 rostopic echo -n1 "$1" && return 0
    sleep 1
  done
  return 1
}
check "roslaunch poinsot demo.launch: a message on /wingnut/state" first_message /wingnut/state
check "roslaunch poinsot demo.launch: a message on /tf" first_message /tf
check "roslaunch poinsot demo.launch: a message on /markers_static" first_message /markers_static
stop_launch

build_against_install() {
  in_space "$install" cmake -S src.gone/poinsot_neighbour -B alone -DPYTHON_EXECUTABLE=/usr/bin/python3 &&
    cmake --build alone && alone/devel/lib/poinsot_neighbour/spin
}
check "the neighbour builds against the install space alone, and runs" build_against_install
check "a program gets the same bits under whatever flags it is compiled with" "$root/test/workspace/test_flags.sh" "$install"

if [ "$failed" -eq 0 ]; then rm -rf "$workspace"; else echo "what was built, and its logs, are in $workspace"; fi
end_checks
