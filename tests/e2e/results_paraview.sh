#!/usr/bin/env bash
# Reads a run with the three XDMF readers of ParaView.   Usage: results_paraview.sh RUN
set -euo pipefail
command -v pvpython >/dev/null || { echo "results_paraview: FAILED: no pvpython; install python3-paraview" >&2; exit 1; }
# A crash of ParaView, or a script that it did not run, must not count as success: the last line is required, too.
output=$(pvpython "$(dirname "$0")/check_paraview.py" "$1" 2>&1) || { echo "$output"; exit 1; }
echo "$output"
grep -q '^paraview: all readers fine$' <<<"$output"
