#!/bin/bash
# Malformed datagrams are sent to a viewer and to a run with --control: both stay alive and count the datagrams that
# they drop, the viewer follows the run to its end, and the results equal those of an undisturbed run.
# 2,000 datagrams; 100,000 with SCREE_FULL=1. Also used with the asan preset.
# usage: live_flood.sh SCREE
set -u
[ $# = 1 ] || { echo "usage: $0 SCREE"; exit 2; }
# shellcheck disable=SC2034
arguments=("$@")  # for the second start, inside the namespace
# shellcheck source=/dev/null
. "$(dirname "$0")/live_namespace.sh" python3
ip route add 224.0.0.0/4 dev lo || skip "no multicast route on the loopback interface"

scree=$1 here=$(dirname "$0")
case_file=$here/live/two_stages.toml
count=2000
[ "${SCREE_FULL:-}" = 1 ] && count=100000
# It lasts some seconds: long enough to be found and paused.
long=(--set stage.runout.duration=16 --set stage.runout.dt=1e-5)
work=$(mktemp -d)
run=
viewer=
trap 'for p in $run $viewer; do kill -9 "$p" 2> /dev/null; done; rm -rf "$work"' EXIT
hash() { python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))["state_hash"])' "$1/summary.json"; }
# ask COMMAND...: repeats the command, since the flood may fill the socket when it is sent
ask() {
  for _ in 1 2 3 4 5; do
    "$scree" control two_stages "$@" --timeout 10 > "$work/answer.txt" 2>&1 && return
    sleep 1
  done
  fail "control $*: $(cat "$work/answer.txt")"
}

python3 "$here/live/terminal.py" "$scree" watch --timeout 20 > "$work/watch.txt" 2> "$work/watch.err" &
viewer=$!
"$scree" run "$case_file" --quiet --live --name two_stages --control "${long[@]}" --out "$work/run" > "$work/run.out" 2> "$work/run.err" &
run=$!
ask pause  # it waits here for the end of the flood
ask step 20
time python3 "$here/live/flood.py" $count two_stages 17 || fail "the flood"
sleep 5  # a viewer that was led to a session that never was comes back after 3 s
kill -0 $run 2> /dev/null || fail "the run did not outlive the flood: $(cat "$work/run.err")"
kill -0 $viewer 2> /dev/null || fail "the viewer did not outlive the flood: $(tail -40 "$work/watch.txt")"
ask resume
wait $run
code=$?
run=
[ $code = 0 ] || fail "the run ended with $code: $(cat "$work/run.err")"
wait $viewer
code=$?
viewer=
[ $code = 0 ] || fail "the viewer ended with $code: $(cat "$work/watch.txt")"
grep -qE '^scree watch  two_stages +done$' "$work/watch.txt" || fail "the viewer missed the end: $(cat "$work/watch.txt")"
foot=$(tail -n 1 "$work/watch.txt")
malformed=$(sed -nE 's/.* ([0-9]+) malformed.*/\1/p' <<< "$foot")
# One datagram in twelve is a valid chunk sent again, and a part of the forged ones differs in numbers only.
[ "${malformed:-0}" -ge $((count / 4)) ] || fail "the viewer counted ${malformed:-0} of $count: $foot"
grep 'control: .* messages' "$work/run/run.log" || fail "the run counted nothing"
"$scree" run "$case_file" --quiet "${long[@]}" --out "$work/alone" || fail "the run left alone"
[ "$(hash "$work/run")" = "$(hash "$work/alone")" ] || fail "the flood changed the state"
! grep -q Sanitizer "$work/run.err" "$work/watch.txt" || fail "a sanitizer: $(cat "$work/run.err" "$work/watch.txt")"
echo "ok: $count datagrams; $foot"
