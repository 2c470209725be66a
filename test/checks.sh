# shellcheck shell=bash
# Sourced by tests that are scripts, after scripts/common.sh: checks, counted, each a line as script_result.py reads them.
# shellcheck disable=SC2154  # build: scripts/common.sh
set +e
passed=0 failed=0
logs=$build  # what a checked command prints is left there

# good WORDS: a check has passed.
good() {
  echo "PASS  $1"
  passed=$((passed + 1))
}

# bad WORDS: a check has failed; details come from standard input.
bad() {
  echo "FAIL  $1"
  sed 's/^/        /'
  failed=$((failed + 1))
}

# expect WORDS EXIT_CODE PATTERN COMMAND...: what the command prints, on both streams, must match the pattern, if there is one.
expect() {
  local words=$1 code=$2 pattern=$3 got log
  shift 3
  mkdir -p "$logs"
  log=$logs/$(printf %s "$words" | tr -c 'A-Za-z0-9\n' _).log
  "$@" > "$log" 2>&1 < /dev/null
  got=$?
  if [ "$got" -eq "$code" ] && { [ -z "$pattern" ] || grep -qE -- "$pattern" "$log"; }; then
    good "$words"
  else
    bad "$words: exit $got, expected $code and /$pattern/; its output is in $log" < <(
      grep -m 1 -A 40 -E 'runtime error|[ :]error: |ERROR: |WARNING: ThreadSanitizer|Failure$|FAILURE' "$log" || tail -n 40 "$log")
  fi
}

# check WORDS COMMAND...: the command must succeed.
check() {
  local words=$1
  shift
  expect "$words" 0 '' "$@"
}

# end_checks: the last line; whether all have passed.
end_checks() {
  echo "$passed passed, $failed failed"
  [ "$failed" -eq 0 ]
}
