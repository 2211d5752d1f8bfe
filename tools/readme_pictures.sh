#!/usr/bin/env bash
# Draws the picture of README.md anew, from the run of ./demo, and prints the figures that the texts about the staged slope
# quote: README.md, cases/staged-slope/README.md.   usage: tools/readme_pictures.sh [SCREE [RUN]]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
scree=${1:-$root/build/release/app/scree} run=${2:-$root/runs/staged-slope}
[ -e "$run/summary.json" ] || "$scree" run "$root/cases/staged-slope/case.toml" --out "$run"
"$scree" snapshot "$run" --at end --out "$root/docs/images/staged-slope.png"
python3 - "$run" <<'END'
import csv, json, sys
run = json.load(open(sys.argv[1] + "/summary.json"))
with open(sys.argv[1] + "/energy.csv") as file:
    rows = list(csv.reader(file))
head = [name.split(" ")[0] for name in rows[0]]
time, kinetic = ([float(row[head.index(name)]) for row in rows[1:]] for name in ("time", "kinetic"))
peak = max(range(len(kinetic)), key=kinetic.__getitem__)
moved = sorted((b["displacement"], b["name"]) for b in run["blocks"])
print(f"{run['status']} at {run['final_time']:g} s, {run['blocks_count']} blocks, {len(run['warnings'])} warnings")
print(f"farthest {moved[-1][0]:.1f} m ({moved[-1][1]}); {sum(d > 1 for d, _ in moved)} blocks moved more than 1 m")
print(f"kinetic energy {kinetic[-1] / 1e3:.0f} kJ at the end, {kinetic[peak] / 1e6:.1f} MJ at most, at {time[peak]:.2f} s")
END
