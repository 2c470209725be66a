# shellcheck shell=bash
# Sourced, instead of scripts/common.sh, by tests that look at the package's own files or work with a copy of them.
source "$(dirname "${BASH_SOURCE[0]}")/../scripts/common.sh"

# package_files: names relative to $root, each followed by a zero byte; without what a build leaves.
package_files() {
  if git -C "$root" ls-files --error-unmatch package.xml > /dev/null 2>&1; then
    git -C "$root" ls-files -z -co --exclude-standard | while IFS= read -r -d '' file; do
      [ ! -f "$root/$file" ] || printf '%s\0' "$file"  # listed but deleted
    done
  else  # unpacked from an archive
    (cd "$root" && find . \( -path ./build -o -path ./bin -o -path ./.git -o -name __pycache__ \) -prune -o -type f -printf '%P\0')
  fi
}

# copy_package DIRECTORY: the package's files, into a directory that is made.
copy_package() {
  mkdir -p "$1"
  package_files | tar -C "$root" --null -T - -cf - | tar -C "$1" -xf -
}

# start_checks DIRECTORY: checks run there, and leave what they print in its folder logs.
start_checks() {
  checks_in=$1 logs=$1/logs passed=0 failures=0
  mkdir -p "$logs" "$1/home"
  # Neither the user's ~/.ros, nor a workspace that the shell has sourced, nor another graph takes part.
  use_ccache "$root"
  export HOME=$1/home
  for name in $(compgen -e | grep -E '^(ROS_|CMAKE_PREFIX_PATH|LD_LIBRARY_PATH|PKG_CONFIG_PATH|CATKIN_)'); do unset "$name"; done
  user_graph=''
  stay_on_loopback "$(free_port)"
}

# check WORDS COMMAND...: runs the command in the directory of the checks and says how it went.
check() {
  local words=$1 log
  shift
  log=$logs/$(printf %s "$words" | tr -c 'A-Za-z0-9\n' _).log
  if (cd "$checks_in" && "$@") > "$log" 2>&1; then
    echo "PASS  $words"
    passed=$((passed + 1))
  else
    echo "FAIL  $words ($log)"
    tail -n 12 "$log" | sed 's/^/        /'
    failures=$((failures + 1))
  fi
}

# end_checks: counts them; what they left stays for looking at where one failed. Whether all passed.
end_checks() {
  if [ "$failures" -eq 0 ]; then rm -rf "$checks_in"; else echo "what was built, and its logs, are in $checks_in"; fi
  echo "$passed passed, $failures failed"
  [ "$failures" -eq 0 ]
}
