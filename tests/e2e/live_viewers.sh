#!/bin/bash
# Viewers of one run: early ones, late ones, one that is stopped (SIGSTOP), one that is killed. All others end in the
# state of the file, the screens of `scree watch` are the same line for line, and the run neither waits nor changes.
# usage: live_viewers.sh SCREE
set -u
[ $# = 1 ] || { echo "usage: $0 SCREE"; exit 2; }
# shellcheck disable=SC2034
arguments=("$@")  # for the second start, inside the namespace
# shellcheck source=/dev/null
. "$(dirname "$0")/live_namespace.sh" python3
/usr/bin/python3 -c 'import h5py, numpy' 2> /dev/null || skip "python3-h5py is not installed"
ip route add 224.0.0.0/4 dev lo || skip "no multicast route on the loopback interface"

scree=$1 here=$(dirname "$0")
# It lasts some seconds: long enough to be found and paused.
case=("$here/live/two_stages.toml" --set stage.runout.duration=16 --set stage.runout.dt=1e-5)
reader=$here/../../docs/examples/read_live.py
work=$(mktemp -d)
pids=()
trap '[ ${#pids[@]} = 0 ] || kill -9 "${pids[@]}" 2> /dev/null; rm -rf "$work"' EXIT
value() { python3 -c 'import json, sys; d = json.load(open(sys.argv[1]))
for k in sys.argv[2:]: d = d[k]
print(d)' "$@"; }

"$scree" run "${case[@]}" --quiet --out "$work/absent/two_stages" || fail "the run without streaming"
"$scree" run "${case[@]}" --quiet --live --out "$work/unseen/two_stages" || fail "the run that nobody watches"

declare -A viewer
# look NAME COMMAND...: starts a viewer in the background
look() {
  local name=$1
  shift
  "$@" > "$work/$name.txt" 2> "$work/$name.err" &
  viewer[$name]=$!
  pids+=($!)
}
listeners() { tail -n +2 /proc/net/udp | grep -c ':1DF3 '; }
look early-screen python3 "$here/live/terminal.py" "$scree" watch --timeout 60
look early-reader python3 "$reader" --timeout 60 --state "$work/early-reader.json"
look stalled "$scree" watch --timeout 60
look killed "$scree" watch --timeout 60
for _ in $(seq 600); do
  [ "$(listeners)" -ge 4 ] && break
  sleep 0.05
done
[ "$(listeners)" -ge 4 ] || fail "the viewers do not listen"
kill -STOP "${viewer[stalled]}"

"$scree" run "${case[@]}" --quiet --live --control --out "$work/watched/two_stages" 2> "$work/run.err" &
run=$!
pids+=($run)
# Paused, so that the late viewers join a run that began long before.
"$scree" control two_stages pause --timeout 20 > "$work/control.txt" 2>&1 || fail "$(cat "$work/control.txt")"
kill -9 "${viewer[killed]}"
look late-reader python3 "$reader" --timeout 60 --state "$work/late-reader.json"
look late-screen python3 "$here/live/terminal.py" "$scree" watch --timeout 60
sleep 2.5
"$scree" control two_stages resume --timeout 20 > "$work/control.txt" 2>&1 || fail "$(cat "$work/control.txt")"
wait $run || fail "the run ended with $?: $(cat "$work/run.err")"
! grep -v "^warning:" "$work/run.err" > "$work/complaints.txt" || fail "the run complained: $(cat "$work/run.err")"
for name in early-screen late-screen early-reader late-reader; do
  wait "${viewer[$name]}" || fail "$name ended with $?: $(cat "$work/$name.txt" "$work/$name.err")"
done

for kind in unseen watched; do
  [ "$(value "$work/$kind/two_stages/summary.json" state_hash)" = "$(value "$work/absent/two_stages/summary.json" state_hash)" ] ||
    fail "the state of the run $kind differs from that without streaming"
done
echo "ok: one state without streaming, with nobody there, and with five viewers"
/usr/bin/python3 "$here/live/same_state.py" "$work/watched/two_stages" "$work"/{early,late}-reader.json || fail "states, above"

"$scree" watch "$work/watched/two_stages" > "$work/stored.txt" || fail "watch of the stored run"
# All lines except the foot, the rate, and the width.
same() { sed -E 's/ +rate [-0-9.e+]+ s\/s, [-0-9.e+]+ steps\/s$//; $d' "$work/$1.txt" | sed -E 's/[#.]{5,}|#+$//; s/ +/ /g; s/~$//' | cut -c 1-70; }
for name in late-screen stored; do
  diff <(same early-screen) <(same $name) || fail "$name (right) ends otherwise than the early screen (left)"
  echo "ok: $name shows what the early screen shows, $(same $name | wc -l) lines"
done

# A stopped viewer does not delay the run; 2 s are allowed for the start of programs.
"$scree" run "${case[@]}" --quiet --live --out "$work/again/two_stages" || fail "the run with a stalled viewer"
[ "$(value "$work/again/two_stages/summary.json" state_hash)" = "$(value "$work/absent/two_stages/summary.json" state_hash)" ] ||
  fail "a stalled viewer changed the state"
python3 - "$work/absent/two_stages/summary.json" "$work/again/two_stages/summary.json" << 'END' || fail "a stalled viewer slows the run down"
import json, sys
alone, stalled = (json.load(open(name))["wall_seconds"]["total"] for name in sys.argv[1:])
print(f"alone {alone:.2f} s, with a stalled viewer {stalled:.2f} s")
sys.exit(stalled > 3.0 * alone + 2.0)
END
