#!/usr/bin/python3
"""A run has the threads that it was given and no others: a library with threads of its own would let them spin.

Usage: own_threads.py SCREE
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import time

CASE = pathlib.Path(__file__).resolve().parents[2] / "cases/four-blocks/case.toml"


def threads_of(scree, given, out):
    """Largest number of threads of a run while it takes steps."""
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("OMP_", "GOMP_", "OPENBLAS_"))}
    command = [scree, "run", CASE, "--out", out, "--overwrite", "--quiet", "--threads", str(given)]
    run = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    seen = 0
    while run.poll() is None:
        if (out / "energy.csv").exists():
            try:
                seen = max(seen, len(os.listdir(f"/proc/{run.pid}/task")))
            except FileNotFoundError:
                break
        time.sleep(0.002)
    assert run.wait() == 0, run.returncode
    return seen


def main():
    with tempfile.TemporaryDirectory() as folder:
        for given in (1, 2):
            seen = threads_of(sys.argv[1], given, pathlib.Path(folder) / f"run-{given}")
            assert seen > 0, "the run ended before it was looked at"
            assert seen <= given, f"{seen} threads with --threads {given}"
            print(f"--threads {given}: {seen}")


main()
