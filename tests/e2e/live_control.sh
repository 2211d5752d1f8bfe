#!/bin/bash
# A run is paused, stepped, slowed and stopped from outside: every command is answered, the results are bitwise those of
# an undisturbed run, and only a run with --control has a receiving socket.
# usage: live_control.sh SCREE
set -u
[ $# = 1 ] || { echo "usage: $0 SCREE"; exit 2; }
# shellcheck disable=SC2034
arguments=("$@")  # for the second start, inside the namespace
# shellcheck source=/dev/null
. "$(dirname "$0")/live_namespace.sh" python3
ip route add 224.0.0.0/4 dev lo || skip "no multicast route on the loopback interface"

scree=$1 here=$(dirname "$0")
case_file=$here/live/two_stages.toml
work=$(mktemp -d)
run=
trap '[ -z "$run" ] || kill -9 "$run" 2> /dev/null; rm -rf "$work"' EXIT

# receivers PID: sockets of a process that are bound to port 7667
receivers() {
  local inode count=0
  for inode in $(find "/proc/$1/fd" -lname 'socket:*' -printf '%l\n' 2> /dev/null | tr -dc '0-9\n'); do
    awk -v i="$inode" '$10 == i && $2 ~ /:1DF3$/ { found = 1 } END { exit !found }' "/proc/$1/net/udp" && count=$((count + 1))
  done
  echo $count
}
# begin NAME OPTIONS...: starts a long run in the background
begin() {
  local name=$1
  shift
  "$scree" run "$case_file" --quiet --live --name two_stages --out "$work/$name" "$@" > "$work/$name.out" 2> "$work/$name.err" &
  run=$!
}
# expect CODE TEXT COMMAND...: the required exit code, and a text that stdout or stderr must contain
expect() {
  local code=$1 text=$2 got
  shift 2
  "$scree" control "$@" > "$work/answer.txt" 2>&1
  got=$?
  [ $got = "$code" ] || fail "control $*: exit code $got instead of $code: $(cat "$work/answer.txt")"
  grep -qF -- "$text" "$work/answer.txt" || fail "control $*: not \"$text\": $(cat "$work/answer.txt")"
}
hash() { python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))["state_hash"])' "$1/summary.json"; }
field() { sed -nE "s/.* at step ([0-9]+), ([-0-9.e+]+) s.*/\\$1/p" "$work/answer.txt"; }

# --- without --control: no receiving socket, and no answer to commands
begin deaf --set stage.runout.duration=100
for _ in $(seq 100); do
  [ "$(tail -n +2 /proc/net/udp | wc -l)" -ge 1 ] && break
  sleep 0.05
done
sleep 0.3
[ "$(tail -n +2 /proc/net/udp | wc -l)" -ge 1 ] || fail "the run does not stream: $(cat "$work/deaf.err")"
[ "$(receivers $run)" = 0 ] || fail "a run without --control has a socket that receives"
expect 5 'takes no commands' two_stages pause --timeout 1
kill -INT $run
wait $run
run=
echo "ok: no socket that receives without --control, and no answer"

# --- usage
expect 2 'rate needs' two_stages rate
expect 2 'whole number' two_stages step 1.5
expect 2 'takes no value' two_stages pause 3
expect 2 'udpm:// only' memq:// pause
expect 5 'no run was received' udpm:// pause --timeout 1
"$scree" run "$case_file" --quiet --control --out "$work/usage" 2> "$work/err.txt"
code=$?
[ $code = 2 ] && [ ! -e "$work/usage" ] || fail "--control without --live: $code: $(cat "$work/err.txt")"
"$scree" run "$case_file" --quiet --control --live="file://$work/log" --out "$work/usage" 2> "$work/err.txt"
code=$?
[ $code = 2 ] && [ ! -e "$work/usage" ] || fail "--control with a log: $code: $(cat "$work/err.txt")"

# --- an undisturbed run, and one that is paused repeatedly
duration=100  # several seconds of computing, and more: time to be found, stopped and found again
"$scree" run "$case_file" --quiet --set stage.runout.duration=$duration --out "$work/alone" || fail "the run left alone"
begin held --control --set stage.runout.duration=$duration
expect 0 'pause done, paused' two_stages pause
[ "$(receivers $run)" = 1 ] || fail "$(receivers $run) sockets receive in a run with --control"
before=$(field 1)
sleep 0.3
expect 0 'step done, paused' two_stages step
[ "$(field 1)" = $((before + 1)) ] || fail "from step $before one step led to $(field 1)"
expect 0 'step done, paused' two_stages step 100
[ "$(field 1)" = $((before + 101)) ] || fail "from step $before 101 steps led to $(field 1)"
"$scree" watch --once > "$work/paused.txt" || fail "watch of a paused run: $(cat "$work/paused.txt")"
grep -qE '^scree watch  two_stages +paused$' "$work/paused.txt" || fail "watch does not say paused: $(cat "$work/paused.txt")"
expect 0 'checkpoint done' two_stages checkpoint
expect 0 'rate done' two_stages rate 5
expect 0 'resume done, running' udpm:// resume
expect 0 'pause done' two_stages pause
for n in 1 2 3; do
  expect 0 'step done' two_stages step $((10 * n))
done
expect 0 'resume done' two_stages resume
wait $run
code=$?
run=
[ $code = 0 ] || fail "the held run ended with $code: $(cat "$work/held.err")"
[ "$(hash "$work/alone")" = "$(hash "$work/held")" ] || fail "holding the run changed its state"
for file in history.csv energy.csv; do
  cmp "$work/alone/$file" "$work/held/$file" || fail "holding the run changed $file"
done
grep -q 'control: step 100: done' "$work/held/run.log" || fail "run.log does not tell of commands: $(cat "$work/held/run.log")"
echo "ok: state $(hash "$work/alone") held and alone"

# --- commands that must be refused, sent directly; then stop
begin stopped --control --set stage.runout.duration=1000
python3 "$here/live/forged_commands.py" two_stages || fail "forged commands, above"
expect 0 'stop done' two_stages stop
wait $run
code=$?
run=
[ $code = 130 ] || fail "the stopped run ended with $code: $(cat "$work/stopped.err")"
grep -q 'interrupted' "$work/stopped/summary.json" || fail "the stopped run has no summary that says so"
grep 'control: .* messages' "$work/stopped/run.log" || fail "run.log has no counts: $(cat "$work/stopped/run.log")"

# --- a paused run reacts to signals; Ctrl-C ends it
begin signalled --control --set stage.runout.duration=1000
expect 0 'pause done' two_stages pause
kill -INT $run
wait $run
code=$?
run=
[ $code = 130 ] || fail "a paused run ended with $code on Ctrl-C"

# --- no network: one warning (besides those of the undisturbed run), and the run continues
ip route del 224.0.0.0/4
"$scree" run "$case_file" --quiet --live --control --out "$work/noroute" 2> "$work/noroute.err" || fail "the run without a route"
[ "$(grep -c 'live streaming' "$work/noroute.err")" = 1 ] && [ "$(grep -c 'control over' "$work/noroute.err")" = 1 ] &&
  [ "$(grep -vc "the ledger's column" "$work/noroute.err")" = 2 ] || fail "not one warning each: $(cat "$work/noroute.err")"
echo "ok: refused commands, stop, Ctrl-C while paused, no route"
