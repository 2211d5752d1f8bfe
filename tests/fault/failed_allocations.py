#!/usr/bin/python3
"""One allocation fails in each run: the run must end with exit code 1 or 5, or with 0 and complete results.

Usage: failed_allocations.py SCREE [--full | --at N [N ...]]
The default tests a sample of allocations of the whole run; --full tests each of the first 2,000 and 500 later ones.
"""
import collections
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
CASE = HERE.parent / "e2e/resume/motion.toml"
QUICK, QUICK_SECONDS = 60, 15.0
WHOLE = ("run.vtkhdf", "summary.json", "history.csv", "energy.csv", "run.xmf")


def main():
    scree, words = sys.argv[1], sys.argv[2:]
    with tempfile.TemporaryDirectory(prefix="scree-malloc-") as folder:
        place = pathlib.Path(folder)
        library = place / "fail_malloc.so"
        subprocess.run(["cc", "-O1", "-shared", "-fPIC", "-o", library, HERE / "fail_malloc.c"], check=True)
        run = place / "run"

        def once(at):
            shutil.rmtree(run, ignore_errors=True)
            environment = dict(os.environ, LD_PRELOAD=str(library), FAIL_MALLOC_AT=str(at), OMP_NUM_THREADS="1",
                               OPENBLAS_NUM_THREADS="1", FAIL_MALLOC_COUNT=str(place / "count"))
            return subprocess.run([scree, "run", str(CASE), "--out", str(run), "--quiet", "--until", "0.005"],
                                  env=environment, capture_output=True, text=True, errors="replace", timeout=120)

        done = once(0)
        assert done.returncode == 0, done.stderr
        count = int((place / "count").read_text())
        draw = random.Random(1)
        if words[:1] == ["--at"]:
            numbers = [int(n) for n in words[1:]]
        elif words == ["--full"]:
            numbers = [*range(1, min(2000, count) + 1), *draw.sample(range(2001, max(count, 2502)), 500)]
        else:
            numbers = draw.sample(range(1, min(2000, count)), QUICK // 2) + draw.sample(range(1, count), QUICK // 2)
        tally, faults, begin = collections.Counter(), [], time.monotonic()
        for n in numbers:
            if not words and time.monotonic() - begin > QUICK_SECONDS:
                break
            done = once(n)
            code = done.returncode
            tally[signal.Signals(-code).name if code < 0 else f"exit code {code}"] += 1
            if code not in (0, 1, 5):
                faults.append(f"allocation {n}: {code}: {done.stderr.strip()[-200:]}")
            elif code == 0 and not all((run / name).is_file() for name in WHOLE):
                faults.append(f"allocation {n}: exit code 0 without whole results")
    print(f"{sum(tally.values())} of {count} allocations: " + ", ".join(f"{k}: {v}" for k, v in sorted(tally.items())))
    for text in faults:
        print("FAULT: " + text)
    return 1 if faults else 0


sys.exit(main())
