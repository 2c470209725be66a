# shellcheck shell=bash
# Sourced by the other scripts: paths, common functions, and an environment in which Debian's ROS works.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build

# ROS's Python modules are those of Debian: another python3 first in PATH would not find them.
export PATH=/usr/bin:/bin:$PATH
unset PYTHONHOME PYTHONPATH
export PYTHONNOUSERSITE=1

# Whether the user has set the ROS graph, noted before any setup.bash sets defaults.
user_graph=${ROS_MASTER_URI:-}${ROS_IP:-}${ROS_HOSTNAME:-}
[ "$user_graph" != http://localhost:11311 ] || user_graph=  # this is such a default, from a setup.bash that the user sourced

# stay_on_loopback PORT: keeps the ROS graph on this machine, with the master on that port.
stay_on_loopback() {
  unset ROS_HOSTNAME
  export ROS_IP=127.0.0.1 ROS_MASTER_URI=http://127.0.0.1:$1
}

# usage: prints the comment at the head of the script.
usage() { sed -n '2,/^[^#]/{s/^# \{0,1\}//p}' "$0"; }

say() { printf '\n== %s\n' "$*"; }
fail() { printf '%s\n' "$*" >&2; exit 1; }
bad_use() { printf '%s\n' "$*" >&2; exit 2; }

# scene_names: prints the names of the scenes in scenes/, one a line.
scene_names() { (cd "$root/scenes" && printf '%s\n' *.yaml | sed 's|\.yaml$||'); }

# use_ccache ROOT: lets ccache, if it is installed, recognise a source file in another copy of the package.
use_ccache() {
  command -v ccache > /dev/null || return 0
  CCACHE_DIR=${CCACHE_DIR:-$(ccache --get-config cache_dir)}  # kept when a test changes HOME
  # Where a path has a blank, ccache 4.7 stores lists of dependencies that name the files of this very copy: another copy
  # that was given such a list would not compile its own file again when it changes. So there ccache only reads. Lists that it
  # stored before are in no namespace, where they are not found.
  export CCACHE_DIR CCACHE_BASEDIR=$1 CCACHE_NOHASHDIR=1 CCACHE_NAMESPACE=poinsot
  unset CCACHE_READONLY
  case $1 in *[[:space:]]*) export CCACHE_READONLY=1 ;; esac
}

# logged COMMAND...: writes the output of the command to build/build.log, and shows it if the command fails.
logged() {
  local log=$build/build.log
  if ! "$@" > "$log" 2>&1; then
    grep -nE -A4 'error|Error' "$log" | head -60 >&2 || true
    tail -n 20 "$log" >&2
    fail "the build failed; its output is in $log"
  fi
}

# configure_package [-DOPTION=VALUE ...]: configures a Release build, unless the build directory or an option says otherwise.
# A new build directory has no tests and benchmarks, which need more packages, unless an option asks for them. If CI is set,
# warnings are errors.
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

# build_package [-DOPTION=VALUE ...] TARGET ...: configures and builds these targets.
build_package() {
  local options=()
  while [[ ${1:-} == -D* ]]; do
    options+=("$1")
    shift
  done
  configure_package "${options[@]}"
  logged cmake --build "$build" --parallel "$(nproc)" --target "$@"
  # rosrun finds no program below the build/ of a package, but follows links.
  ln -sfn build/devel/lib/poinsot "$root/bin"
}

# enter_devel: makes the built package visible to roslaunch, rosrun and rospy.
enter_devel() {
  set +u
  # shellcheck disable=SC1091
  source "$build/devel/setup.bash"
  set -u
}

# free_port: prints a TCP port on loopback on which nobody listens.
free_port() {
  python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}

# port_taken PORT: whether somebody listens on that port on loopback.
port_taken() { (exec 3<> "/dev/tcp/127.0.0.1/$1") 2> /dev/null; }

# await_rviz LAUNCH_PID: waits until RViz subscribes to markers. Returns 1 if the launch has ended, 2 after a minute.
await_rviz() {
  for _ in $(seq 120); do
    kill -0 "$1" 2> /dev/null || return 1
    if timeout 5 rostopic info /markers 2> /dev/null | grep -A3 Subscribers | grep -q rviz; then return 0; fi
    sleep 0.5
  done
  return 2
}

# start_core LOG: starts a ROS master on loopback and waits until it answers; sets core_pid.
start_core() {
  local deadline
  for _ in 1 2 3 4 5; do  # another program may take the port before roscore does
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

# start_graph: starts a ROS graph with a ROS_HOME of its own; processes in `pids` end with the script.
start_graph() {
  ROS_HOME=$(mktemp -d)
  export ROS_HOME
  pids=()
  trap 'kill "${pids[@]}" 2> /dev/null || true; wait; rm -rf "$ROS_HOME"' EXIT
  start_core "$ROS_HOME/roscore.log"
  pids+=("$core_pid")
}

# start_display [WxH]: starts a virtual screen on which software OpenGL can draw; sets DISPLAY and display_pid.
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
