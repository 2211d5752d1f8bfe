#!/usr/bin/env bash
# `scree view` of a stored run and of a case, as a user types it, and its page in a browser without a window.
# Usage: view_page.sh SCREE SOURCE BUILD
set -euo pipefail
scree=$1 source=$2 build=$3
# shellcheck source=tests/e2e/report_modules.sh
. "$(dirname "$0")/report_modules.sh"
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
fail() { echo "view_page: FAILED: $*" >&2; exit 1; }

case_file=$source/tests/e2e/report/case.toml
OMP_NUM_THREADS=1 "$scree" run "$case_file" --out "$out/run" --quiet 2>/dev/null
OMP_NUM_THREADS=1 "$scree" run "$case_file" --set 'model.gravity=[0, -20]' --set stage.fall.duration=0.4 --out "$out/other" --quiet 2>/dev/null

refuse() {  # exit code, part of the message, arguments
  local code=0 message
  message=$("$scree" view "${@:3}" 2>&1) || code=$?
  [ "$code" = "$1" ] || fail "exit code $code, not $1, of view ${*:3}"
  [[ $message == *"$2"* ]] || fail "view ${*:3} gives \"$message\", without \"$2\""
}
refuse 2 'nothing to show'
refuse 5 'run.vtkhdf' "$out"
refuse 3 'does not exist' "$out/none.toml"
refuse 2 'not in range' "$out/run" --port 70000
refuse 2 'not a case' "$case_file" --compare "$out/run"
refuse 5 'run.vtkhdf' "$out/run" --compare "$out"
refuse 2 'tcpq' --live=tcpq://127.0.0.1:7700

mkdir "$out/tmp"
TMPDIR=$out/tmp timeout --preserve-status -s INT 2 "$scree" view "$case_file" >/dev/null || fail "a case cannot be viewed"
[ -z "$(ls "$out/tmp")" ] || fail "view of a case leaves $(ls "$out/tmp")"

chromium=$(command -v chromium || command -v chromium-browser || true)
[ -n "$chromium" ] || { echo "skipped: no Chromium here"; exit 77; }
viewer_modules "$source" "$build"
CHROMIUM=$chromium MODULES=$modules node "$source/tests/e2e/view/stored.mjs" "$scree" "$out/run" "$out/other" "$case_file"
OMP_NUM_THREADS=1 "$scree" run "$source/tests/e2e/view/marks.toml" --out "$out/marks" --quiet 2>/dev/null
"$scree" report "$out/marks" --out "$out/marks.html" >/dev/null
CHROMIUM=$chromium MODULES=$modules node "$source/tests/e2e/view/layers.mjs" "$out/marks.html" ${SCREE_PICTURES:-}
