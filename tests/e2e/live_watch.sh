#!/bin/bash
# `scree watch` as a user sees it, on a terminal, in a network namespace: it waits for a run, follows it, counts
# malformed messages, and restores the terminal; viewers that start late receive the mesh within 2 s; exit codes.
# usage: live_watch.sh SCREE CASE
set -u
[ $# = 2 ] || { echo "usage: $0 SCREE CASE"; exit 2; }
# shellcheck disable=SC2034
arguments=("$@")  # for the second start, inside the namespace
# shellcheck source=/dev/null
. "$(dirname "$0")/live_namespace.sh" tmux python3 lcm-logger
ip route add 224.0.0.0/4 dev lo || skip "no multicast route on the loopback interface"

scree=$1 case_file=$2
url='udpm://239.255.76.67:7667?ttl=0'
work=$(mktemp -d)
run=
logger=
terminal() { env -u TMUX tmux -S "$work/tmux" -f /dev/null "$@"; }
cleanup() {
  terminal kill-server 2> /dev/null
  [ -z "$run" ] || kill "$run" 2> /dev/null
  [ -z "$logger" ] || kill "$logger" 2> /dev/null
  rm -rf "$work"
}
trap cleanup EXIT

screen() { terminal capture-pane -p -t "$1"; }
# wait_for PANE TEXT: waits until the pane shows the text, 20 s at most
wait_for() {
  for _ in $(seq 100); do
    screen "$1" | grep -qF -- "$2" && return
    sleep 0.2
  done
  screen "$1"
  fail "pane $1 never showed \"$2\""
}

# Exit codes without a run.
"$scree" watch --timeout 0.5 > "$work/none.txt" 2>&1
code=$?
[ $code = 5 ] || fail "exit code $code where nothing streams: $(cat "$work/none.txt")"
grep -q 'no data from any run' "$work/none.txt" || fail "it does not say why: $(cat "$work/none.txt")"
"$scree" watch tcpq://127.0.0.1:7700 > /dev/null 2>&1
code=$?
[ $code = 2 ] || fail "exit code $code for a URL that is not accepted"
"$scree" watch "$work/no/run" > /dev/null 2>&1
code=$?
[ $code = 5 ] || fail "exit code $code for a folder that is not there"

# A waiting viewer; bytes of a foreign program on one of Scree's channels.
terminal new-session -d -s early -x 80 -y 24 "echo text before; '$scree' watch --timeout 60; echo exit code \$?; sleep 600" ||
  skip "tmux cannot make a terminal here"
wait_for early 'waiting for a run'
python3 - << 'END'
import socket, struct
out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
out.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 0)
out.sendto(struct.pack(">II", 0x4C433032, 1) + b"SCREE_x_INFO\0" + b"\x7f" * 100, ("239.255.76.67", 7667))
END
wait_for early '1 malformed'

lcm-logger --quiet --lcm-url="$url" "$work/log" > "$work/logger.txt" 2>&1 &
logger=$!
# A finer mesh: the run lasts longer than all following checks.
"$scree" run "$case_file" --set stage.settle.cover_size=0.7 --live --quiet --out "$work/run" > "$work/out.txt" 2> "$work/err.txt" &
run=$!

# simulated_time PANE: the time shown on the screen; empty if none is shown
simulated_time() { screen "$1" | sed -nE 's/.*%  ([0-9.]+) of [0-9.]+ s.*/\1/p' | head -1; }
advances=0 last=
for _ in $(seq 300); do
  now=$(simulated_time early)
  if [ -n "$now" ] && { [ -z "$last" ] || awk "BEGIN { exit !($now > $last) }"; }; then
    [ -z "$last" ] || advances=$((advances + 1))
    last=$now
  fi
  [ $advances -ge 5 ] && break
  sleep 0.1
done
[ $advances -ge 3 ] || { screen early; fail "the simulated time advanced $advances times"; }
echo "ok: the simulated time on the screen advanced $advances times, to $last s"
screen early

# Late viewers, at several instants between two transmissions of the mesh. The time is measured from the start of the
# program.
for pause in 0 0.5 0.4 0.7; do
  sleep $pause
  kill -0 "$run" 2> /dev/null || fail "the run ended before every late viewer had looked"
  "$scree" watch --once > "$work/late.txt" 2>&1 || fail "a late viewer: $(cat "$work/late.txt")"
  after=$(sed -nE 's/.*mesh after ([0-9.]+) s.*/\1/p' "$work/late.txt")
  [ -n "$after" ] || fail "a late viewer has no mesh: $(cat "$work/late.txt")"
  echo "late viewer: mesh after $after s"
  awk "BEGIN { exit !($after <= 2.0) }" || fail "a late viewer waited $after s for the mesh"
done
for section in 'ENERGY [J]' 'MONITORS' 'EVENTS' 'stage start'; do
  grep -qF "$section" "$work/late.txt" || fail "a late viewer has no $section: $(cat "$work/late.txt")"
done

# Ctrl-C restores a terminal of another size.
terminal new-session -d -s large -x 120 -y 40 "echo text before; '$scree' watch; echo exit code \$?; sleep 600"
wait_for large 'MONITORS'
[ "$(terminal display-message -p -t large '#{alternate_on} #{cursor_flag}')" = '1 0' ] || fail "no screen of its own"
screen large
terminal send-keys -t large C-c
wait_for large 'exit code 130'
[ "$(terminal display-message -p -t large '#{alternate_on} #{cursor_flag}')" = '0 1' ] || fail "the terminal is not put back"

# The run receives the command to stop: the viewer shows that and ends.
kill -INT "$run" || fail "the run was over before it was asked to stop"
wait "$run"
code=$?
run=
[ $code = 130 ] || fail "the run ended with $code: $(cat "$work/err.txt")"
wait_for early 'exit code 0'
terminal capture-pane -p -S - -t early > "$work/end.txt"
grep -q 'text before' "$work/end.txt" || fail "the terminal is not as it was: $(cat "$work/end.txt")"
grep -qE 'scree watch .* interrupted$' "$work/end.txt" || fail "the end is not shown: $(cat "$work/end.txt")"

# The same run, stored.
"$scree" watch "$work/run" > "$work/stored.txt" || fail "the stored run: $?"
grep -qE '^scree watch  run .* interrupted$' "$work/stored.txt" || fail "the stored run: $(cat "$work/stored.txt")"

sleep 0.3
kill -INT "$logger"
wait "$logger"
logger=
python3 "$(dirname "$0")/live_log.py" "$work/log" --need INFO TOPO STATE HIST ENERGY EVENT --largest 60000 \
  --longest-gap TOPO 2 || fail "the log, above"
