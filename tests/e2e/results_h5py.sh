#!/usr/bin/env bash
# Reads a run with h5py.   Usage: results_h5py.sh RUN
set -euo pipefail
python=/usr/bin/python3  # Debian's: the one that python3-h5py is for
"$python" -c 'import h5py' || { echo "results_h5py: FAILED: no h5py; install python3-h5py" >&2; exit 1; }
here=$(dirname "$0")
"$python" "$here/check_results.py" "$1" --contacts || exit
"$python" "$here/check_mesh.py" "$1"
"$python" "$here/../../docs/examples/read_mesh.py" "$1" > "$1/read_mesh.txt"
grep -q "cells, stress from" "$1/read_mesh.txt"
"$python" "$here/../../docs/examples/read_results.py" "$1/run.vtkhdf" | grep 'ledger: closed'
