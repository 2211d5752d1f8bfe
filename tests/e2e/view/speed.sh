#!/usr/bin/env bash
# Speed at which the page animates 10,000 blocks with 60,000 vertices in software rendering: frames per second of wall time, and processor
# time per frame. Run by hand, on an idle machine: speed.sh SCREE SOURCE BUILD [LEAST], with exit code 1 below LEAST frames per second (30).
set -euo pipefail
scree=$1 source=$2 build=$3 least=${4:-30}
# shellcheck source=tests/e2e/report_modules.sh
. "$(dirname "$0")/../report_modules.sh"
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
python3 - > "$out/case.toml" << 'END'
from math import cos, pi, sin
print('title = "10,000 blocks that fall"\n[material.rock]\ndensity = 2500.0\nyoung = "5 GPa"\npoisson = 0.25')
for row in range(100):
    for column in range(100):
        corners = [[round(3 * column + cos(k * pi / 3), 6), round(3 * row + sin(k * pi / 3), 6)] for k in range(6)]
        print(f'[[block]]\nname = "b{row}-{column}"\nmaterial = "rock"\npolygon = {corners}')
print('[[stage]]\nname = "fall"\nmethod = "dda"\nintegrator = "implicit"\ndt = "20 ms"\nduration = 2.0\n[output]\nevery = "20 ms"')
END
nice "$scree" run "$out/case.toml" --out "$out/run" --quiet 2> /dev/null
chromium=$(command -v chromium || command -v chromium-browser || true)
[ -n "$chromium" ] || { echo "skipped: no Chromium here"; exit 77; }
viewer_modules "$source" "$build"
CHROMIUM=$chromium MODULES=$modules node "$source/tests/e2e/view/speed.mjs" "$scree" "$out/run" "$least"
