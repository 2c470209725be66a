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

# leave_user_behind DIRECTORY: HOME is below it from here on, and neither a workspace that the shell has sourced nor another
# graph takes part. ccache stays the user's, and knows files below the directory again in another one.
leave_user_behind() {
  use_ccache "$1"
  mkdir -p "$1/home"
  export HOME=$1/home
  for name in $(compgen -e | grep -E '^(ROS_|CMAKE_PREFIX_PATH|LD_LIBRARY_PATH|PKG_CONFIG_PATH|CATKIN_)'); do unset "$name"; done
  user_graph=''
  stay_on_loopback "$(free_port)"
}
