#!/usr/bin/env bash
# Makes the run that the other results tests read: the staged case, until after its hand-overs from DDA to NMM and back,
# with a shortened shaking.
# Usage: results_run.sh SCREE CASE OUT
set -euo pipefail
out=$3
mkdir -p "$(dirname "$out")"
"$1" run "$2" --out "$out" --overwrite --set stage.shaking.duration=0.05 --set output.contacts=true --until 0.9 --quiet
for file in run.vtkhdf run.xmf summary.json; do
  [ -s "$out/$file" ] || { echo "results_run: no $file in $out" >&2; exit 1; }
done
