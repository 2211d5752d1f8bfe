#!/usr/bin/python3
"""One write, fsync, truncation or rename of a run fails, is cut short, or the program is killed at it; the run is
resumed.

Usage: io_faults.py SCREE LIBRARY        (failing_io.cc, built as a module)
A small staged run with a hand-over and checkpoints: some of its calls by default, each of them with SCREE_FULL=1. A call
that fails must end the run with code 5 and name a file of the folder; the resumed run must equal the uninterrupted one:
every dataset and attribute, every table, the hash of its state. Then larger staged runs (resume/: a hand-over, a partitioned
stage, a switch) are killed while they write checkpoints at changes of stage, and at other instants. Exit code 77: not
possible on this machine.
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
polygon = [[0, 0], [1, 0], [1, 0.5], [0, 0.5]]
material = "rock"
[[support]]
block = "base"
[[monitor]]
name = "top"
point = [0.5, 0.5]
[output]
every = 0.0005
checkpoint_steps = 4
contacts = true
[[stage]]
name = "solid"
method = "nmm"
integrator = "implicit"
dt = 0.0005
duration = 0.002
[[stage]]
name = "block"
method = "dda"
integrator = "explicit"
duration = 0.001
"""

faults = resume_runs.faults
fault = resume_runs.fault


def run(scree, library, folder, *arguments, at=0, kind="", trace=None):
    environment = dict(os.environ, OMP_WAIT_POLICY="passive", OMP_NUM_THREADS="1")
    if library:
        environment.update(LD_PRELOAD=str(library), SCREE_FAULT_FOLDER=str(folder), SCREE_FAULT_AT=str(at), SCREE_FAULT_KIND=kind)
        if trace:
            environment["SCREE_FAULT_TRACE"] = str(trace)
    done = subprocess.run([scree, *map(str, arguments)], capture_output=True, text=True, env=environment, timeout=120, check=False)
    return done.returncode, done.stderr


def calls_of(scree, library, folder, ask, scratch):
    """Intercepted calls of a run in order, each with the name of its file."""
    trace = scratch / "trace"
    code, err = run(scree, library, folder, *ask, trace=trace)
    names = trace.read_text().splitlines() if trace.exists() else []
    if code != 0 or not names:
        print(f"SKIPPED: calls cannot be watched here ({code}: {err.strip()})")
        sys.exit(resume_runs.SKIPPED)
    return [(call, pathlib.Path(name).name) for call, _, name in (line.partition(" ") for line in names)]


def try_at(scree, library, folder, ask, whole, at, kind, what, tally):
    """Runs with one fault, then resumes the run."""
    code, err = run(scree, library, folder, *ask, at=at, kind=kind)
    tally[kind, code] = tally.get((kind, code), 0) + 1
    if kind.startswith("kill"):
        if code != -9:
            fault(f"{what}: exit code {code}: {err.strip()}")
    elif code != 5 or str(folder) not in err:
        fault(f"{what}: exit code {code}: {err.strip()}")
    if not resume_runs.finish(resume_runs.Scree(scree), folder, ask, what):
        return
    if list(folder.glob("*damaged*")):
        fault(f"{what}: a file was put aside: {[p.name for p in folder.glob('*damaged*')]}")
    for line in resume_runs.differences(folder, whole):
        fault(f"{what}: {line}")


def main():
    scree, library = sys.argv[1:3]
    rng = random.Random(17)
    tally = {}
    with tempfile.TemporaryDirectory(prefix="scree-io-") as scratch:
        scratch = pathlib.Path(scratch)
        small, whole, folder = scratch / "case.toml", scratch / "whole", scratch / "run"
        small.write_text(CASE)
        ask = ["run", small, "--out", folder, "--quiet", "--overwrite"]
        code, err = run(scree, None, whole, "run", small, "--out", whole, "--quiet")
        assert code == 0, err
        calls = len(calls_of(scree, library, folder, ask, scratch))
        for line in resume_runs.differences(folder, whole):
            fault(f"no fault: {line}")
        for kind in ("eio", "enospc", "short", "kill", "killed"):
            last = calls - (kind == "short")  # the last call syncs the folder: it cannot be cut short, and no call follows it
            for at in range(1, last + 1) if FULL else sorted(rng.sample(range(1, last + 1), 4)):
                try_at(scree, library, folder, ask, whole, at, kind, f"{kind} at call {at} of {calls}", tally)
        print(f"{calls} calls; by kind and exit code: {tally}", flush=True)

        for name in ("staged", "sides", "rules") if FULL else ("rules",):
            tally = {}
            case, whole, folder = resume_runs.HERE / f"{name}.toml", scratch / f"{name}-whole", scratch / name
            ask = ["run", case, "--out", folder, "--quiet", "--overwrite"]
            code, err = run(scree, None, whole, "run", case, "--out", whole, "--quiet")
            assert code == 0, err
            names = calls_of(scree, library, folder, ask, scratch)
            inside = [n + 1 for n, (_, file) in enumerate(names) if file.startswith("checkpoint")]
            beside = sorted({n + d for n in inside for d in range(-15, 16) if 0 < n + d <= len(names)} - set(inside))
            for places in (inside, beside, range(1, len(names) + 1)):
                for at in sorted(rng.sample(places, min(len(places), 24 if FULL else 1))):
                    kind = rng.choice(("kill", "killed"))
                    try_at(scree, library, folder, ask, whole, at, kind, f"{name}, {kind} at call {at} of {len(names)}", tally)
            print(f"{name}: {len(names)} calls, {len(inside)} of them of checkpoints; {tally}", flush=True)

        # HDF5 shortens the file at times, and writes on: a log then has more than the file. Whether it does so in a run
        # depends on the lengths of texts, such as paths.
        tally = {}
        for steps in (100, 90, 80, 70, 60, 50):
            often = [*ask, "--set", f"output.checkpoint_steps={steps}"]
            names = calls_of(scree, library, folder, often, scratch)
            shorter = [n + 1 for n, (call, file) in enumerate(names) if call.startswith("ftruncate") and file == "run.vtkhdf"]
            if shorter:
                break
        for at in shorter:
            try_at(scree, library, folder, often, whole, at, "killed", f"{name}, killed after it was shortened", tally)
        print(f"{name}: {len(shorter)} truncations; {tally}", flush=True)
    print(f"{len(faults)} faults")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
