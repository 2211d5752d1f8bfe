#!/bin/bash
# Cost of streaming: 2,000 sliding DDA blocks, explicit; every step (10 to 20 ms of wall time) is stored and offered as
# a frame, and frames are streamed at 30 Hz to a viewer on the same machine. Runs with and without streaming alternate.
# Prints ratios of the medians: wall time; processor time of the computing thread; processor time of the whole program,
# which includes the thread that encodes and sends. Exit code 1 if streaming costs more than 1 % of the wall time, by
# every measure: the wall time itself (shortest runs, medians), and the additional processor time of the computing
# thread divided by the wall time (on a busy machine wall times are noise).
# Run by hand, on an idle machine: SCREE_FULL=1 live_cost.sh SCREE [TURNS [no-viewer|pages]]. Without a viewer the test
# measures streaming alone, as when the viewer runs on another machine: a viewer uses as much time as the encoding
# thread.
# pages: `scree view --live` passes the stream on to ten WebSockets, in place of `scree watch`.
set -u
[ $# -ge 1 ] || { echo "usage: SCREE_FULL=1 $0 SCREE [TURNS]"; exit 2; }
[ "${SCREE_FULL:-}" = 1 ] || { echo "SKIPPED: set SCREE_FULL=1; it takes minutes"; exit 77; }
# shellcheck disable=SC2034
arguments=("$@")  # for the second start, inside the namespace
# shellcheck source=/dev/null
. "$(dirname "$0")/live_namespace.sh" python3
ip route add 224.0.0.0/4 dev lo || skip "no multicast route on the loopback interface"

scree=$1 turns=${2:-5} viewers=${3:-viewer}
work=$(mktemp -d)
viewer=
trap '[ -z "$viewer" ] || kill -9 "$viewer" 2> /dev/null; rm -rf "$work"' EXIT
python3 - > "$work/case.toml" << 'END'
print('''title = "Wall of 2,000 blocks"
[model]
gravity = [3.0, -9.81]
default_joint = "joint"
[joint.joint]
friction_deg = 30.0
[material.rock]
density = 2500.0
young = "5 GPa"
poisson = 0.25
[[block]]
name = "floor"
polygon = [[-1, -1], [51, -1], [51, 0], [-1, 0]]
material = "rock"
[[support]]
block = "floor"
[[stage]]
name = "slide"
method = "dda"
integrator = "explicit"
dt = "auto"
duration = "30 ms"
[output]
every = "50 us"
history_every = "50 us"''')
for row in range(40):
    for column in range(50):
        x, y = column + 0.0, row + 0.0
        print(f'[[block]]\nname = "b{row}-{column}"\nmaterial = "rock"\n'
              f'polygon = [[{x}, {y}], [{x + 1}, {y}], [{x + 1}, {y + 1}], [{x}, {y + 1}]]')
END
watch() {
  [ "$viewers" != no-viewer ] || return 0
  [ "$viewers" != pages ] || return 0
  python3 "$(dirname "$0")/live/terminal.py" "$scree" watch --timeout 0 > /dev/null &
  viewer=$!
}
if [ "$viewers" = pages ]; then
  "$scree" view --live > "$work/address" &
  viewer=$!
  for _ in $(seq 100); do grep -q http "$work/address" && break; sleep 0.1; done
  python3 "$(dirname "$0")/view/viewers.py" "$(grep http "$work/address")" 10 > "$work/pages" &
  pages=$!
fi
watch
# timed NAME OPTIONS...: a run; writes the processor time of its first thread [ns] to NAME.ns
timed() {
  local name=$1
  shift
  "$scree" run "$work/case.toml" --quiet --threads 1 --out "$work/$name" "$@" &
  local run=$!
  while used=$(cut -d ' ' -f 1 "/proc/$run/task/$run/schedstat" 2> /dev/null) && [ -n "$used" ]; do
    echo "$used" > "$work/$name.ns"
    sleep 0.02
  done
  wait $run
}
for i in $(seq "$turns"); do
  timed "off$i" || fail "turn $i without streaming"
  timed "on$i" --live || fail "turn $i with streaming"
  [ -n "$viewer" ] && kill -0 "$viewer" 2> /dev/null || watch
done
[ "$viewers" != pages ] || { kill -TERM $pages; wait $pages; cat "$work/pages"; }
python3 - "$work" "$turns" << 'END'
import json, os, re, statistics, sys
work, turns = sys.argv[1], int(sys.argv[2])
kinds = {k: [json.load(open(f"{work}/{k}{i}/summary.json")) for i in range(1, turns + 1)] for k in ("off", "on")}
hashes = {s["state_hash"] for list_ in kinds.values() for s in list_}
def median(kind, key):
    return statistics.median(key(s) for s in kinds[kind])
wall = [median(k, lambda s: s["wall_seconds"]["total"]) for k in ("off", "on")]
cpu = [median(k, lambda s: s["cpu_seconds"]) for k in ("off", "on")]
thread = [statistics.median(int(open(f"{work}/{k}{i}.ns").read()) * 1e-9 for i in range(1, turns + 1))
          for k in ("off", "on")]
print(f"{len(hashes)} state, {kinds['on'][0]['steps']} steps, {kinds['on'][0]['blocks_count']} blocks, {turns} turns")
print(f"wall {wall[0]:.2f} s without, {wall[1]:.2f} s with streaming: ratio {wall[1] / wall[0]:.4f}")
print(f"computing thread {thread[0]:.2f} s without, {thread[1]:.2f} s with streaming: ratio {thread[1] / thread[0]:.4f}")
print(f"processor {cpu[0]:.2f} s without, {cpu[1]:.2f} s with streaming: ratio {cpu[1] / cpu[0]:.4f}")
if os.path.exists(f"{work}/pages"):
    frames = int(re.search(r"(\d+) to \d+ frames each", open(f"{work}/pages").read())[1])
    stepping = sum(s["wall_seconds"][k] for s in kinds["on"] for k in ("explicit", "output"))
    print(f"{frames / stepping:.1f} frames a second to each page in {stepping:.1f} s of steps and output")
# A busy host makes runs longer, never shorter: the shortest run of each kind is nearest to its undisturbed time.
least = [min(s["wall_seconds"]["total"] for s in kinds[k]) for k in ("off", "on")]
print(f"shortest wall {least[0]:.2f} s without, {least[1]:.2f} s with streaming: ratio {least[1] / least[0]:.4f}")
share = (thread[1] - thread[0]) / wall[1]
print(f"the computing thread gives up {100 * share:.2f} % of the wall time")
sys.exit(len(hashes) != 1 or min(least[1] / least[0] - 1, wall[1] / wall[0] - 1, share) > 0.01)
END
