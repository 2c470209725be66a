#!/usr/bin/env bash
# clang-tidy finds nothing in src/ and include/; .clang-tidy says what it looks for. It has a build directory of its own
# (build/tidy), where files are joined, so that it reads a header once for many. The last line reads "N passed, M failed".
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../../scripts/common.sh"

export build=$build/tidy
build_package -DCMAKE_CXX_COMPILER=clang++ -DPOINSOT_BUILD_PANEL=ON -DPOINSOT_JOIN_FILES=ON \
  poinsot_generate_messages_cpp poinsot_rviz_autogen
source "$here/../checks.sh"

export work=$build/work
rm -rf "$work"
mkdir -p "$work/sample/src/core" "$work/sample/include/poinsot/core"

cat > "$work/sample/include/poinsot/core/sample.h" << 'END'
inline int twice(int badParameter) { return 2 * badParameter; }
END
cat > "$work/sample/src/core/sample.cpp" << 'END'
#include <string>
#include <vector>
#include "poinsot/core/sample.h"
int total(const std::vector<std::string>& words) {
  int badName = 0;
  for (const std::string word : words) badName += twice(word.empty());
  return badName;
}
END
sample=(clang-tidy --quiet "$work/sample/src/core/sample.cpp" -- -std=c++17 "-I$work/sample/include")
expect notices_a_bad_name 1 "sample.cpp:5:.*local variable 'badName'" "${sample[@]}"
expect notices_a_copy 1 'sample.cpp:6:.*performance-for-range-copy' "${sample[@]}"
expect notices_a_fault_in_a_header 1 "sample.h:1:.*parameter 'badParameter'" "${sample[@]}"

sources() { python3 "$here/tidy_sources.py" "$root" "$build" "$work" | tee "$work/sources"; }
expect knows_every_source 0 '^core' sources

# tidy ROOM FILE: what clang-tidy says of the file goes into a log.
tidy() {
  local log
  log=$(mktemp "$work/$1.XXXXXX")
  clang-tidy --quiet -p "$work" "$2" > "$log" 2>&1
  echo "exit $?: $2" >> "$log"
}
export -f tidy
# shellcheck disable=SC2016  # for the inner bash
tr '\t' '\n' < "$work/sources" | xargs -d '\n' -P 2 -n 2 bash -c 'tidy "$1" "$2"' tidy

# said ROOM: prints what clang-tidy said; fails unless it found nothing in each of the room's files.
said() {
  cat "$work/$1".*
  [ "$(cat "$work/$1".* | grep -c '^exit 0: ')" -eq "$(grep -c "^$1"$'\t' "$work/sources")" ]
}
cut -f 1 "$work/sources" | sort -u > "$work/rooms"
while read -r room; do
  expect "$room" 0 '^exit 0: ' said "$room"
done < "$work/rooms"
end_checks
