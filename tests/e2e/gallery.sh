#!/usr/bin/env bash
# `scree gallery` as a user types it, and its page in a browser without a window.
# Usage: gallery.sh SCREE SOURCE BUILD
set -euo pipefail
scree=$1 source=$2 build=$3
# shellcheck source=tests/e2e/report_modules.sh
. "$(dirname "$0")/report_modules.sh"
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
fail() { echo "gallery: FAILED: $*" >&2; exit 1; }
export OMP_NUM_THREADS=1 SCREE_CASES=$out/cases

mkdir -p "$out/cases/one"
cp "$source/tests/e2e/report/case.toml" "$out/cases/one/case.toml"
cp "$source/cases/incline/expected.toml" "$out/cases/one/expected.toml"
mkdir "$out/cases/study" && cp "$source/cases/sdof/expected.toml" "$out/cases/study"
"$scree" run "$source/tests/e2e/live/two_stages.toml" --out "$out/mine" --quiet 2>/dev/null
mkdir "$out/empty"

said=$("$scree" gallery --out "$out/all" 2>/dev/null)
[[ $said == $'one: runs\n'"$out/all/index.html"$'\n1 runs' ]] || fail "says \"$said\""
for file in index.html one.html one.png runs/one/summary.json; do [ -s "$out/all/$file" ] || fail "no $file"; done
said=$("$scree" gallery --out "$out/all")
[[ $said == "$out/all/index.html"* ]] || fail "runs a case again: \"$said\""
echo '# changed' >>"$out/cases/one/case.toml"
said=$("$scree" gallery --out "$out/all" 2>/dev/null)
[[ $said == "one: runs"* ]] || fail "does not run a case that has changed: \"$said\""

code=0
said=$("$scree" gallery one "$out/mine" "$out/mine" "$out/empty" --out "$out/some" 2>"$out/error") || code=$?
[ $code = 1 ] || fail "exit code $code where a run cannot be shown"
grep -q 'error: empty: .*run.vtkhdf' "$out/error" || fail "says of the empty folder: $(cat "$out/error")"
[ -s "$out/some/mine.html" ] && [ -s "$out/some/mine-2.html" ] || fail "one of two runs with one name is lost"
code=0
said=$("$scree" gallery nothing --out "$out/none" 2>&1) || code=$?
[ $code = 2 ] && [[ $said == *"allowed: one"* ]] || fail "exit code $code, \"$said\""
[ ! -e "$out/none" ] || fail "leaves a folder behind"

chromium=$(command -v chromium || command -v chromium-browser || true)
[ -n "$chromium" ] || { echo "skipped: no Chromium here"; exit 77; }
viewer_modules "$source" "$build"
CHROMIUM=$chromium MODULES=$modules node "$source/tests/e2e/report/gallery.mjs" "$out/some"
