# shellcheck shell=bash
# Phases of a script: prints a title before each phase and its time afterwards. To be sourced by bash scripts.
#
#   phase NAME COMMAND...   runs the command; returns its code. Within it, use `|| return`: bash ignores set -e there.
#   quietly COMMAND...      output to a log; the end of the log is shown if the command fails
#   phase_times             one line per phase, with its time

phase_rows=()

phase() {
  local name=$1 start=$SECONDS code=0 verdict=''
  shift
  printf '\n==> %s\n' "$name"
  "$@" || code=$?
  [ $code = 0 ] || verdict="  FAILED (code $code)"
  phase_rows+=("$(printf '  %-28s %5d s%s' "$name" $((SECONDS - start)) "$verdict")")
  [ $code = 0 ] || echo "==> $name failed with code $code after $((SECONDS - start)) s" >&2
  return $code
}

phase_times() {
  printf '\nTime\n'
  [ ${#phase_rows[@]} = 0 ] || printf '%s\n' "${phase_rows[@]}"
  printf '  %-28s %5d s\n' "all" "$SECONDS"
}

quietly() {
  local log code=0
  log=$(mktemp "${TMPDIR:-/tmp}/scree-log.XXXXXX")
  "$@" >"$log" 2>&1 || code=$?
  [ $code = 0 ] || tail -n 40 "$log" >&2
  rm -f "$log"
  return $code
}

# run_ctest FILE COMMAND...   runs ctest and keeps in FILE its closing lines, from the count of passed tests on
run_ctest() {
  local file=$1 log code=0
  shift
  log=$(mktemp "${TMPDIR:-/tmp}/scree-ctest.XXXXXX")
  rm -f "$file"
  "$@" 2>&1 | tee "$log" || code=${PIPESTATUS[0]}
  sed -n '/^[0-9]*% tests passed, /,$p' "$log" >"$file"
  rm -f "$log"
  if [ ! -s "$file" ]; then
    echo "ctest ran no test" | tee "$file" >&2
    return $((code ? code : 1))
  fi
  return "$code"
}
