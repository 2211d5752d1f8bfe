#!/bin/bash
# A stored run is sent again by `scree replay`, and a log of the stream by LCM's own player: the last screen of
# `scree watch` equals that of the live run line for line, except the foot (number of messages) and the rate (that of
# the replay).
# usage: live_replay.sh SCREE
set -u
[ $# = 1 ] || { echo "usage: $0 SCREE"; exit 2; }
# shellcheck disable=SC2034
arguments=("$@")  # for the second start, inside the namespace
# shellcheck source=/dev/null
. "$(dirname "$0")/live_namespace.sh" python3 lcm-logplayer
ip route add 224.0.0.0/4 dev lo || skip "no multicast route on the loopback interface"

scree=$1 here=$(dirname "$0")
url='udpm://239.255.76.67:7667?ttl=0'
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/live" "$work/log"

# watch NAME: a viewer in the background; its last screen is written to NAME.txt
watch() {
  python3 "$here/live/terminal.py" "$scree" watch --timeout 30 > "$work/$1.txt" &
  viewer=$!
  for _ in $(seq 100); do
    grep -q ':1DF3 ' /proc/net/udp && break
    sleep 0.05
  done
  sleep 0.2
}
seen() { wait "$viewer" || fail "viewer of $1: exit code $?: $(cat "$work/$1.txt")"; }

case_file=$here/live/two_stages.toml
watch live
"$scree" run "$case_file" --quiet --live --out "$work/live/two_stages" || fail "the live run"
seen live
"$scree" run "$case_file" --quiet --live="file://$work/stream.log" --out "$work/log/two_stages" || fail "the logged run"
watch replay
"$scree" replay "$work/live/two_stages" --speed 0.5 > "$work/replay.out" || fail "replay: $(cat "$work/replay.out")"
seen replay
watch replay-at-once
"$scree" replay "$work/live/two_stages" --speed 0 > "$work/at-once.out" || fail "replay at once"
grep -q '^52 of 52 frames sent$' "$work/at-once.out" || fail "not every frame was sent: $(cat "$work/at-once.out")"
seen replay-at-once
watch player
lcm-logplayer --lcm-url="$url" "$work/stream.log" > /dev/null || fail "lcm-logplayer"
seen player
python3 "$here/live/terminal.py" "$scree" watch "file://$work/stream.log" > "$work/from-log.txt" || fail "watch of the log"

# The foot counts messages; the rate is that of the player.
same() { sed -E 's/ +rate [-0-9.e+]+ s\/s, [-0-9.e+]+ steps\/s$//; $d' "$work/$1.txt"; }
lines=$(same live | wc -l)
[ "$lines" -ge 20 ] || fail "the screen of the live run has $lines lines: $(cat "$work/live.txt")"
for who in replay replay-at-once player from-log; do
  diff <(same live) <(same "$who") || fail "$who (right) ends otherwise than the live run (left)"
  echo "ok: $who ends as the live run, $lines lines"
done
cat "$work/replay.txt"

# Files that cannot be replayed.
"$scree" replay "$work" > /dev/null 2> "$work/err.txt"
code=$?
[ $code = 5 ] || fail "exit code $code for a folder that is no run: $(cat "$work/err.txt")"
"$scree" replay "$work/live/two_stages" --live tcpq://127.0.0.1:7700 > /dev/null 2> "$work/err.txt"
code=$?
[ $code = 2 ] || fail "exit code $code for a URL that is not accepted: $(cat "$work/err.txt")"
