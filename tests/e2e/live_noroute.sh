#!/bin/bash
# A run with --live where no multicast route exists: one warning, and the same results as without streaming.
# usage: live_noroute.sh SCREE CASE
set -u
[ $# = 2 ] || { echo "usage: $0 SCREE CASE"; exit 2; }
# shellcheck disable=SC2034
arguments=("$@")  # for the second start, inside the namespace
# shellcheck source=/dev/null
. "$(dirname "$0")/live_namespace.sh" python3

scree=$1 case_file=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$scree" run "$case_file" --until 0.05 --out "$work/off" > "$work/off.txt" 2> "$work/off.err" ||
  fail "the run without streaming: $(cat "$work/off.err")"
"$scree" run "$case_file" --live --until 0.05 --out "$work/on" > "$work/on.txt" 2> "$work/on.err" ||
  fail "the run with streaming: $(cat "$work/on.err")"

# Every line on stderr counts, also messages of the LCM library.
lines=$(diff "$work/off.err" "$work/on.err" | grep -c '^>')
[ "$lines" = 1 ] || fail "$lines lines of warning instead of one: $(cat "$work/on.err")"
grep -q 'no multicast route' "$work/on.err" || fail "the warning does not say why: $(cat "$work/on.err")"
[ -s "$work/on/run.vtkhdf" ] || fail "no results"

hash() { python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))["state_hash"])' "$1/summary.json"; }
off=$(hash "$work/off") || fail "no state hash in summary.json"
on=$(hash "$work/on") || fail "no state hash in summary.json"
[ "$off" = "$on" ] || fail "state hash $on with streaming, $off without"
echo "ok: one warning, state $on either way"
