#!/bin/bash
# `scree view --live` in a browser without a window, in a network namespace from which no other machine can be reached.
# Usage: view_live.sh SCREE SOURCE BUILD
set -u
[ $# = 3 ] || { echo "usage: $0 SCREE SOURCE BUILD"; exit 2; }
# shellcheck disable=SC2034
arguments=("$@")  # for the second start, inside the namespace
scree=$1 source=$2 build=$3
chromium=$(command -v chromium || command -v chromium-browser || true)
[ -n "$chromium" ] || { echo "skipped: no Chromium here"; exit 77; }
# Before the namespace is entered, since the packages may have to be downloaded.
# shellcheck source=tests/e2e/report_modules.sh
. "$(dirname "$0")/report_modules.sh"
viewer_modules "$source" "$build"
# shellcheck source=/dev/null
. "$(dirname "$0")/live_namespace.sh" node
ip route add 224.0.0.0/4 dev lo || skip "no multicast route on the loopback interface"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
OMP_NUM_THREADS=1 "$scree" run "$source/tests/e2e/report/case.toml" --out "$work/run" --quiet 2>/dev/null || fail "the run to replay"
OMP_NUM_THREADS=1 "$scree" run "$source/tests/e2e/view/marks.toml" --out "$work/marks" --quiet 2>/dev/null || fail "the run with bolts"
CHROMIUM=$chromium MODULES=$modules node "$source/tests/e2e/view/live.mjs" "$scree" "$work/run" "$source/tests/e2e/live/two_stages.toml" "$work" "$work/marks" ||
  fail "the page, above"
