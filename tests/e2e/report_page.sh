#!/usr/bin/env bash
# `scree report` as a user types it, and its page in a browser without a window.
# Usage: report_page.sh SCREE SOURCE BUILD
set -euo pipefail
scree=$1 source=$2 build=$3
# shellcheck source=tests/e2e/report_modules.sh
. "$(dirname "$0")/report_modules.sh"
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
fail() { echo "report_page: FAILED: $*" >&2; exit 1; }

OMP_NUM_THREADS=1 "$scree" run "$source/tests/e2e/report/case.toml" --out "$out/run" --quiet 2>/dev/null
said=$("$scree" report "$out/run")
[[ $said == "$out/run/report.html"$'\n'"18 frames, "* ]] || fail "says \"$said\""
"$scree" report "$out/run" --out "$out/again.html" >/dev/null
cmp "$out/run/report.html" "$out/again.html" || fail "the same run gives another page"
said=$("$scree" report "$out/run" --out "$out/thin.html" --size 0.001)
[[ $said == *"5 of 18 frames"* || $said == *"4 of 18 frames"* ]] || fail "does not thin: \"$said\""

refuse() {  # exit code, part of the message, arguments
  local code=0 message
  message=$("$scree" report "${@:3}" 2>&1) || code=$?
  [ "$code" = "$1" ] || fail "exit code $code, not $1, of report ${*:3}"
  [[ $message == *"$2"* ]] || fail "report ${*:3} gives \"$message\", without \"$2\""
}
refuse 5 'run.vtkhdf' "$out"
refuse 2 '0 or a number above' "$out/run" --size -1
refuse 5 'no/where' "$out/run" --out "$out/no/where/r.html"

chromium=$(command -v chromium || command -v chromium-browser || true)
[ -n "$chromium" ] || { echo "skipped: no Chromium here"; exit 77; }
viewer_modules "$source" "$build"
CHROMIUM=$chromium MODULES=$modules node "$source/tests/e2e/report/page.mjs" "$out/run/report.html" "$out/thin.html"
