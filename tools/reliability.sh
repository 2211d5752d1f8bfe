#!/usr/bin/env bash
# Runs the tests behind docs/reliability.md and prints the findings of each, one line per test.
#   tools/reliability.sh [--full] [BUILD]      quick form, or the full form (hours); build/release if no folder is given
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
which=(--label-exclude '^full$')
if [ "${1:-}" = --full ]; then
  export SCREE_FULL=1
  which=()
  shift
fi
build=${1:-build/release}
[ -f "$build/CTestTestfile.cmake" ] || { echo "no build with tests in $build: run ./check first" >&2; exit 2; }

mapfile -t names < <(ctest --test-dir "$build" -N -L reliability "${which[@]}" | sed -n 's/^ *Test *#[0-9]*: //p')
failed=0
for name in "${names[@]}"; do
  code=0
  output=$(ctest --test-dir "$build" -R "^${name//./\\.}\$" -V 2>&1) || code=$?
  result=$(sed -n 's/^ *1\/1 Test.* \(Passed\|.*Failed\|\*\*\*.*\) *\([0-9.]* sec\).*/\1, \2/p' <<<"$output")
  printf '%s: %s\n' "$name" "${result:-did not run}"
  # The output of a test without ctest's own lines; the whole output of a test that failed.
  told=$(sed -n 's/^[0-9]*: //p' <<<"$output" | grep -vE '^(Test command|Working Directory|Environment variables|Test timeout| *[A-Z_]*=)' || true)
  if [ "$code" = 0 ]; then tail -n 8 <<<"$told" | sed 's/^/    /'; else sed 's/^/    /' <<<"$told"; failed=1; fi
done
exit "$failed"
