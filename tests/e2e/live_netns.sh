#!/bin/bash
# A run streams over real multicast, in a network namespace: a logger of LCM itself receives all six kinds of message,
# none above 60 kB; the run opens no receiving socket, and its results equal those without streaming.
# usage: live_netns.sh SCREE CASE
set -u
[ $# = 2 ] || { echo "usage: $0 SCREE CASE"; exit 2; }
# shellcheck disable=SC2034
arguments=("$@")  # for the second start, inside the namespace
# shellcheck source=/dev/null
. "$(dirname "$0")/live_namespace.sh" lcm-logger python3
ip route add 224.0.0.0/4 dev lo || skip "no multicast route on the loopback interface"

scree=$1 case_file=$2
url='udpm://239.255.76.67:7667?ttl=0'
port=':1DF3 '  # 7667, as /proc/net/udp writes it
work=$(mktemp -d)
logger=
trap '[ -z "$logger" ] || kill "$logger" 2> /dev/null; rm -rf "$work"' EXIT

lcm-logger --quiet --lcm-url="$url" "$work/log" > "$work/logger.txt" 2>&1 &
logger=$!
for _ in $(seq 100); do
  grep -q "$port" /proc/net/udp && break
  sleep 0.1
done
grep -q "$port" /proc/net/udp || fail "lcm-logger does not listen: $(cat "$work/logger.txt")"
sleep 0.5  # its self test

"$scree" run "$case_file" --live --until 0.05 --out "$work/run" > "$work/out.txt" 2> "$work/err.txt" &
run=$!
samples=0
while kill -0 "$run" 2> /dev/null; do
  listening=$(grep -c "$port" /proc/net/udp)
  [ "$listening" -le 1 ] || fail "$listening sockets listen on port 7667; only the logger should"
  # The sending socket exists: the list was taken while the run was streaming.
  [ "$(tail -n +2 /proc/net/udp | wc -l)" -ge 2 ] && samples=$((samples + 1))
  sleep 0.01
done
wait "$run" || fail "the run ended with $?: $(cat "$work/err.txt")"
grep -q 'live streaming' "$work/err.txt" && fail "it warned: $(cat "$work/err.txt")"
[ "$samples" -ge 1 ] || fail "the run was never seen streaming"

sleep 0.3
kill -INT "$logger"
wait "$logger"
logger=
python3 "$(dirname "$0")/live_log.py" "$work/log" --need INFO TOPO STATE HIST ENERGY EVENT --largest 60000 || fail "the log, above"

"$scree" run "$case_file" --quiet --until 0.05 --out "$work/off" || fail "the run without streaming"
hash() { python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))["state_hash"])' "$1/summary.json"; }
[ "$(hash "$work/run")" = "$(hash "$work/off")" ] || fail "streaming changed the state"
echo "ok: state $(hash "$work/off") with and without streaming"
echo "ok: $samples looks at the sockets while streaming"
