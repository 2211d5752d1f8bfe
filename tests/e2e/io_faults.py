#!/usr/bin/python3
"""One write, fsync, truncation or rename of a run fails, is cut short, or the program dies there; the run is resumed.

Usage: io_faults.py SCREE LIBRARY        (failing_io.cpp, built as a module)
A small staged run with a hand-over and checkpoints: some of its calls by default, each of them with SCREE_FULL=1. A call
that fails must end the run with code 5 and name a file of the folder; the resumed run must be that which never stopped:
every dataset and attribute, every table, the hash of its state. Exit code 77: cannot be done here.
"""
import os
import pathlib
import random
import subprocess
import sys
import tempfile

import resume_runs

FULL = bool(os.environ.get("SCREE_FULL"))
CASE = """
[material.rock]
density = 2600.0
young = "1 GPa"
poisson = 0.2
[joint.joint]
friction_deg = 30.0
[model]
default_joint = "joint"
cover_size = 1.0
[[block]]
name = "base"
polygon = [[-2, -1], [4, -1], [4, 0], [-2, 0]]
material = "rock"
[[block]]
name = "stone"
polygon = [[0, 0.001], [1, 0.001], [1, 0.501], [0, 0.501]]
material = "rock"
[[support]]
block = "base"
[[monitor]]
name = "top"
point = [0.5, 0.5]
[output]
every = 0.001
checkpoint_steps = 4
contacts = true
[[stage]]
name = "solid"
method = "nmm"
integrator = "implicit"
dt = 0.0005
duration = 0.004
[[stage]]
name = "block"
method = "dda"
integrator = "explicit"
duration = 0.004
"""

faults = resume_runs.faults
fault = resume_runs.fault


def run(scree, library, folder, *arguments, at=0, kind="", count=None):
    environment = dict(os.environ, OMP_WAIT_POLICY="passive", OMP_NUM_THREADS="1")
    if library:
        environment.update(LD_PRELOAD=str(library), SCREE_FAULT_FOLDER=str(folder), SCREE_FAULT_AT=str(at), SCREE_FAULT_KIND=kind)
        if count:
            environment["SCREE_FAULT_COUNT"] = str(count)
    done = subprocess.run([scree, *map(str, arguments)], capture_output=True, text=True, env=environment, timeout=120, check=False)
    return done.returncode, done.stderr


def main():
    scree, library = sys.argv[1:3]
    rng = random.Random(17)
    tally = {}
    with tempfile.TemporaryDirectory(prefix="scree-io-") as scratch:
        scratch = pathlib.Path(scratch)
        case, whole, folder, count = scratch / "case.toml", scratch / "whole", scratch / "run", scratch / "count"
        case.write_text(CASE)
        code, err = run(scree, None, whole, "run", case, "--out", whole, "--quiet")
        assert code == 0, err
        ask = ["run", case, "--out", folder, "--quiet", "--overwrite"]
        code, err = run(scree, library, folder, *ask, count=count)
        if code != 0 or not count.exists() or int(count.read_text()) == 0:
            print(f"SKIPPED: calls cannot be watched here ({code}: {err.strip()})")
            sys.exit(resume_runs.SKIPPED)
        calls = int(count.read_text())
        for line in resume_runs.differences(folder, whole):
            fault(f"no fault: {line}")
        for kind in ("eio", "enospc", "short", "kill", "killed"):
            places = range(1, calls + 1) if FULL else sorted(rng.sample(range(1, calls + 1), 6))
            for at in places:
                what = f"{kind} at call {at} of {calls}"
                code, err = run(scree, library, folder, *ask, at=at, kind=kind)
                end = f"code {code}"
                tally[kind, end] = tally.get((kind, end), 0) + 1
                if kind.startswith("kill"):
                    if code != -9:
                        fault(f"{what}: exit code {code}: {err.strip()}")
                elif code != 5 or str(folder) not in err:
                    fault(f"{what}: exit code {code}: {err.strip()}")
                if not resume_runs.finish(resume_runs.Scree(scree), folder, ["run", case, "--out", folder, "--quiet"], what):
                    continue
                if list(folder.glob("*damaged*")):
                    fault(f"{what}: a file was put aside: {[p.name for p in folder.glob('*damaged*')]}")
                for line in resume_runs.differences(folder, whole):
                    fault(f"{what}: {line}")
    print(f"{calls} calls; {tally}; {len(faults)} faults")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
