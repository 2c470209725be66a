# shellcheck shell=bash
# Sourced by scripts that build in a directory of their own: checks, counted, each a line as scripts/test.sh reads them.
# shellcheck disable=SC2154  # build: common.sh
set +e
passed=0 failed=0

# expect NAME EXIT_CODE PATTERN COMMAND...: the program's streams together must match the pattern.
expect() {
  local name=$1 code=$2 pattern=$3 log=$build/$1.log got
  shift 3
  "$@" > "$log" 2>&1 < /dev/null
  got=$?
  if [ "$got" -eq "$code" ] && grep -qE -- "$pattern" "$log"; then
    passed=$((passed + 1))
    echo "PASS  $name"
  else
    failed=$((failed + 1))
    echo "FAIL  $name: exit $got, expected $code and /$pattern/; its output is in $log"
    { grep -m 1 -A 40 -E 'runtime error|[ :]error: |ERROR: |WARNING: ThreadSanitizer|Failure$|FAILURE' "$log" || tail -n 15 "$log"; } |
      sed 's/^/        /'
  fi
}

# finish: the last line; fails when a check has.
finish() {
  echo "$passed passed, $failed failed"
  [ "$failed" -eq 0 ]
}
