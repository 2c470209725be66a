#!/usr/bin/env bash
# Looks at the package's files: format, shell and Python syntax, links, data files, places that only one machine has.
# Each check is also run on a broken file, where it must fail. The last line reads "N passed, M failed".
source "$(dirname "${BASH_SOURCE[0]}")/../package_copy.sh"
source "$(dirname "${BASH_SOURCE[0]}")/../checks.sh"

work=$(mktemp -d) || exit 1
trap '[ "$failed" -gt 0 ] || rm -rf "$work"' EXIT  # logs are there to be looked at
logs=$work

# Each check takes names of files relative to the present directory, and says nothing where all is well.
format() { clang-format --dry-run -Werror --style="file:$root/.clang-format" "$@"; }
shell() { shellcheck -x -P SCRIPTDIR "$@"; }
files() { /usr/bin/python3 -B "$root/test/static/check_files.py" "$@"; }

# holds WORDS COMMAND...: the check finds nothing, and says nothing.
holds() {
  local words=$1
  shift
  silent() {
    local said code=0
    said=$("$@" 2>&1) || code=$?
    [ -z "$said" ] || printf '%s\n' "$said"
    [ $code -eq 0 ] && [ -z "$said" ]
  }
  check "$words" silent "$@"
}

# notices WORDS PATTERN FILE CONTENT COMMAND...: of a file with that content, the check fails and says what matches.
notices() {
  local words=$1 pattern=$2 file=$3 content=$4
  shift 4
  mkdir -p "$work/broken"
  printf '%b' "$content" > "$work/broken/$file"
  fails_there() (
    cd "$work/broken" || exit 0
    ! "$@" "$file" || exit 0
    exit 1
  )
  expect "notices $words" 1 "$pattern" fails_there "$@"
}

cd "$root" || exit 1
mapfile -d '' -t all < <(package_files)
[ ${#all[@]} -gt 0 ] || fail "check.sh: found no files below $root"
code=() scripts=() python=()
for file in "${all[@]}"; do
  read -r -n 60 first < "$file" 2> /dev/null || true
  case "${file##*/}" in
    *.cpp | *.h) code+=("$file") ;;
    *.sh) scripts+=("$file") ;;
    *.py) python+=("$file") ;;
    *.*) ;;
    *)
      case "$first" in
        '#!'*bash | '#!'*/sh) scripts+=("$file") ;;
        '#!'*python3) python+=("$file") ;;
      esac ;;
  esac
done

holds "C++ is formatted as .clang-format says (${#code[@]} files)" format "${code[@]}"
holds "shellcheck finds nothing (${#scripts[@]} files)" shell "${scripts[@]}"
holds "Python is valid (${#python[@]} files)" files python "${python[@]}"
holds "relative links lead to files and headings" files links "${all[@]}"
holds "YAML and XML files are well-formed" files data "${all[@]}"
holds "no file names a place that only one machine has" files places "${all[@]}"

notices "code that is not formatted" 'broken.cpp:1:.*-Wclang-format-violations' broken.cpp 'int  f( );\n' format
# shellcheck disable=SC2016  # it is the content of a file
notices "an unquoted variable" 'SC2086' broken.sh '#!/bin/bash\nrm $1\n' shell
notices "an error of syntax in a shell script" 'SC1' broken.sh '#!/bin/bash\nif true; then\n' shell
notices "an error of syntax in Python" 'broken.py:2: ' broken.py 'x = 1\nif x\n' files python
notices "a link to a file that does not exist" 'broken.md:3: .*nowhere.md' broken.md 'a\n\n[b](nowhere.md)\n' files links
notices "a picture that does not exist" 'broken.md:1: .*nowhere.png' broken.md '![b](nowhere.png)\n' files links
notices "a link to a heading that does not exist" 'broken.md:3: .*no heading.*#c' broken.md '# A b\n[fine](#a-b)\n[b](#c)\n' files links
notices "a scene that is not YAML" 'broken.yaml:2: ' broken.yaml 'a: 1\nb: ]\n' files data
notices "a view that is not YAML" 'broken.rviz:1: ' broken.rviz 'a: b: c\n' files data
notices "a launch file that is not XML" 'broken.launch:2: ' broken.launch '<launch>\n<node></launch>\n' files data
notices "a test file that is not XML" 'broken.test:1: ' broken.test 'launch\n' files data
notices "a directory of one user" 'broken.cpp:2: .*/home/' broken.cpp '\n"/ho''me/someone/poinsot"\n' files places
notices "text that is not UTF-8" 'broken.md:2: expected UTF-8' broken.md 'a\n\xff\n' files places
notices "a web address outside the list" 'broken.txt:1: .*registry.invalid' broken.txt 'https:/''/registry.invalid/simple\n' files places

end_checks
