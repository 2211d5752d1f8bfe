#!/usr/bin/env bash
# Complete runs under sanitizers, in separate builds.
#   sanitizers.sh SOURCE cases      all quick cases of the library by `scree`, addresses and undefined behaviour (preset asan)
#   sanitizers.sh SOURCE threads    steps on several threads and all live features, races (preset tsan; needs clang-14)
set -euo pipefail

root=$1 what=$2
export OMP_WAIT_POLICY=passive
cd "$root"
log=$(mktemp)
trap 'rm -f "$log"' EXIT

build() {
  local preset=$1
  shift
  cmake --preset "$preset" -DSCREE_TESTS=ON >/dev/null
  cmake --build --preset "$preset" --parallel "$(nproc)" --target "$@" >"$log" 2>&1 || { tail -n 30 "$log"; exit 1; }
}

# Runs a program and shows the messages of the sanitizer.
run() {
  local code=0
  "$@" >"$log" 2>&1 || code=$?
  if grep -qE 'Sanitizer|runtime error' "$log"; then
    grep -nE -A 12 'Sanitizer|runtime error' "$log" | head -n 60
    return 1
  fi
  if [ "$code" != 0 ]; then
    tail -n 30 "$log"
    return "$code"
  fi
  tail -n 1 "$log"
}

case $what in
  cases)
    build asan scree
    export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
    export LSAN_OPTIONS="suppressions=$root/tests/leaks.txt:print_suppressions=0"
    run build/asan/app/scree cases verify --quick
    ;;
  threads)
    command -v clang++-14 >/dev/null || { echo "SKIPPED: no clang++-14"; exit 77; }
    build tsan test_determinism test_golden test_unit_io
    export TSAN_OPTIONS=ignore_noninstrumented_modules=1:halt_on_error=1
    run build/tsan/tests/test_determinism --gtest_filter=-Threads.*  # which times threads
    run build/tsan/tests/test_golden
    run build/tsan/tests/test_unit_io --gtest_filter='*Live*:Control*:Dashboard*:Serve*'
    ;;
  *)
    echo "sanitizers.sh SOURCE cases|threads" >&2
    exit 2
    ;;
esac
