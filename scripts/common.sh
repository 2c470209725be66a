# shellcheck shell=bash
# Sourced by the other scripts: where things are, and a shell in which Debian's ROS works.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build

# ROS's Python modules are Debian's: another python3 first in PATH would not find them.
export PATH=/usr/bin:/bin:$PATH
unset PYTHONHOME PYTHONPATH
export PYTHONNOUSERSITE=1

# Noted before any setup.bash sets defaults: has the user said where the ROS graph is?
user_graph=${ROS_MASTER_URI:-}${ROS_IP:-}${ROS_HOSTNAME:-}
[ "$user_graph" != http://localhost:11311 ] || user_graph=  # such a default, sourced by the user

# stay_on_loopback PORT: keeps the ROS graph on this machine, its master on that port.
stay_on_loopback() {
  unset ROS_HOSTNAME
  export ROS_IP=127.0.0.1 ROS_MASTER_URI=http://127.0.0.1:$1
}

# usage: the comment at the head of the script.
usage() { sed -n '2,/^[^#]/{s/^# \{0,1\}//p}' "$0"; }

say() { printf '\n== %s\n' "$*"; }
fail() { printf '%s\n' "$*" >&2; exit 1; }
bad_use() { printf '%s\n' "$*" >&2; exit 2; }

# scene_names: what scenes/ holds, one a line.
scene_names() { (cd "$root/scenes" && printf '%s\n' *.yaml | sed 's|\.yaml$||'); }

# use_ccache: lets ccache, where it is installed, know a source file again in another copy of the package.
use_ccache() {
  command -v ccache > /dev/null || return 0
  CCACHE_DIR=${CCACHE_DIR:-$(ccache --get-config cache_dir)}  # stays when a test changes HOME
  export CCACHE_DIR CCACHE_BASEDIR=$1 CCACHE_NOHASHDIR=1
}

# logged COMMAND...: its output goes to build/build.log, and is shown where it fails.
logged() {
  local log=$build/build.log
  if ! "$@" > "$log" 2>&1; then
    grep -nE -A4 'error|Error' "$log" | head -60 >&2 || true
    tail -n 20 "$log" >&2
    fail "the build failed; all of its output is in $log"
  fi
}

# configure_package [-DOPTION=VALUE ...]: Release unless the build directory or an option says otherwise. A new build
# directory is without tests and benchmarks, which need more packages, unless an option asks for them; where CI is set, a
# warning ends its builds.
configure_package() {
  local options=(-DPYTHON_EXECUTABLE=/usr/bin/python3)
  mkdir -p "$build"
  use_ccache "$root"
  if [ ! -f "$build/CMakeCache.txt" ]; then
    options+=(-DCATKIN_ENABLE_TESTING=OFF -DPOINSOT_BUILD_BENCHMARKS=OFF "-DPOINSOT_WARNINGS_ARE_ERRORS=${CI:+ON}")
    [ -z "${CCACHE_DIR:-}" ] || options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
    ! command -v ninja > /dev/null || options+=(-G Ninja)
  fi
  logged cmake -S "$root" -B "$build" "${options[@]}" "$@"
}

# build_package [-DOPTION=VALUE ...] TARGET ...: configures and builds.
build_package() {
  local options=()
  while [[ ${1:-} == -D* ]]; do
    options+=("$1")
    shift
  done
  configure_package "${options[@]}"
  logged cmake --build "$build" --parallel "$(nproc)" --target "$@"
  # rosrun finds no program below a package's own build/, but follows links.
  ln -sfn build/devel/lib/poinsot "$root/bin"
}

# enter_devel: makes the built package visible to roslaunch, rosrun and rospy.
enter_devel() {
  set +u
  # shellcheck disable=SC1091
  source "$build/devel/setup.bash"
  set -u
}

# free_port: a TCP port on loopback that nobody listens on.
free_port() {
  python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}

# port_taken PORT: does somebody listen there, on loopback?
port_taken() { (exec 3<> "/dev/tcp/127.0.0.1/$1") 2> /dev/null; }

# await_rviz LAUNCH_PID: until RViz is up, that is, listens to what moves. 1: the launch has ended; 2: a minute has gone by.
await_rviz() {
  for _ in $(seq 120); do
    kill -0 "$1" 2> /dev/null || return 1
    if timeout 5 rostopic info /markers 2> /dev/null | grep -A3 Subscribers | grep -q rviz; then return 0; fi
    sleep 0.5
  done
  return 2
}

# start_core LOG: a ROS master on loopback that answers; sets core_pid.
start_core() {
  local deadline
  for _ in 1 2 3 4 5; do  # somebody else may take the port between the search for it and roscore
    stay_on_loopback "$(free_port)"
    roscore -p "${ROS_MASTER_URI##*:}" > "$1" 2>&1 &
    core_pid=$!
    deadline=$((SECONDS + 30))
    while [ "$SECONDS" -lt "$deadline" ] && kill -0 "$core_pid" 2> /dev/null; do
      timeout 5 rosparam list > /dev/null 2>&1 && return
      sleep 0.2
    done
    kill "$core_pid" 2> /dev/null || true
  done
  cat "$1" >&2
  fail "roscore does not start"
}

# start_graph: a ROS graph and a ROS_HOME of its own; what is added to `pids` ends with the script.
start_graph() {
  ROS_HOME=$(mktemp -d)
  export ROS_HOME
  pids=()
  trap 'kill "${pids[@]}" 2> /dev/null || true; wait; rm -rf "$ROS_HOME"' EXIT
  start_core "$ROS_HOME/roscore.log"
  pids+=("$core_pid")
}

# start_display: a virtual screen that software OpenGL can draw on; sets DISPLAY and display_pid.
start_display() {
  local number
  number=$(mktemp)
  Xvfb -displayfd 3 -screen 0 "${1:-1600x900}x24" +extension GLX -nolisten tcp 3> "$number" > /dev/null 2>&1 &
  display_pid=$!
  for _ in $(seq 100); do
    [ -s "$number" ] && break
    kill -0 "$display_pid" 2> /dev/null || fail "Xvfb does not start"
    sleep 0.1
  done
  DISPLAY=:$(cat "$number")
  export DISPLAY LIBGL_ALWAYS_SOFTWARE=1
  rm -f "$number"
}
