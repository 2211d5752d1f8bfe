#!/usr/bin/python3
"""Random jointed rock, by explicit, implicit and partitioned steps: no stage may continue endlessly with tiny steps.

Usage: progress_runs.py SCREE [MODELS [FIRST]]
A run may take 20 times the processor time of its implicit twin (and 5 s); one that takes more must have ended with an
error that states the cause. The audit reports nothing, and no energy is created; 1, 2 and 3 threads give the same bits.
Models: 200 with SCREE_FULL=1, else the first ones and those that showed faults.
"""
import json
import os
import pathlib
import random
import resource
import subprocess
import sys
import tempfile

FULL = bool(os.environ.get("SCREE_FULL"))
# A small friction force without a normal force; a thin wedge whose tip was allowed to penetrate.
SEEN = (67, 84)
FLOOR = 5.0  # processor time that every run may take [s]
TIMES = 20.0
CASE = """
[model]
default_joint = "joint"
cover_size = {cover}
[material.rock]
density = 2600.0
young = {young}
poisson = 0.2
[joint.joint]
friction_deg = {friction}
cohesion = {cohesion}
[domain]
outline = {outline}
material = "rock"
prefix = "rock"
least_area = {least}
least_width = 0.3
[[domain.region]]
name = "base"
polygon = [[0, 0], [{width}, 0], [{width}, 1], [0, 1]]
cut = false
{sets}
[[support]]
block = "base-1"
[[stage]]
name = "stage"
method = "{method}"
integrator = "{integrator}"
{options}
duration = {duration}
"""
SET = """[[domain.joint_set]]
dip_deg = {dip}
dip_deviation_deg = {deviation}
spacing = {spacing}
spacing_deviation = {spread}
joint = "joint"
"""

faults = []


def fault(text):
    faults.append(text)
    print("  FAULT: " + text, flush=True)


def model(rng):
    """The part of the case that does not depend on the scheme."""
    width, height = rng.uniform(8, 16), rng.uniform(4, 9)
    outline = [[0, 0], [width, 0], [width, 1], [width - rng.uniform(0, 0.4) * width, height], [0, height]]
    sets = "".join(SET.format(dip=dip % 180, deviation=rng.uniform(0, 5), spacing=rng.uniform(1.2, 3.0), spread=rng.uniform(0, 0.4))
                   for dip in (rng.uniform(0, 180), rng.uniform(0, 180)))
    return dict(cover=1.0, friction=rng.choice((20, 35, 50)), cohesion=rng.choice((0, 0, 1e5)), outline=outline,
                least=0.3, seed=rng.randrange(1 << 20), width=width, sets=sets, method=rng.choice(("nmm", "nmm", "dda")),
                duration=0.02)


class Run:
    def __init__(self, scree, case, out, limit, threads=1):
        def before():
            resource.setrlimit(resource.RLIMIT_CPU, (int(limit) + 2, int(limit) + 12))  # XCPU, then KILL
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        environment = dict(os.environ, OMP_WAIT_POLICY="passive")
        done = subprocess.run([scree, "run", case, "--out", out, "--quiet", "--overwrite", "--audit", "--threads", str(threads)],
                              capture_output=True, text=True, env=environment, preexec_fn=before, check=False)
        now = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.cpu = now.ru_utime + now.ru_stime - used.ru_utime - used.ru_stime
        self.code, self.err = done.returncode, done.stderr.strip()
        self.summary = json.loads((out / "summary.json").read_text()) if self.code in (0, 4) else {}

    def digest(self):
        return self.summary.get("state_hash")


def main():
    scree = sys.argv[1]
    first = int(sys.argv[3]) if len(sys.argv) > 3 else 0
    models = range(first, first + int(sys.argv[2])) if len(sys.argv) > 2 else range(200) if FULL else (0, *SEEN)
    tally = {}
    worst = 0.0
    with tempfile.TemporaryDirectory(prefix="scree-progress-") as scratch:
        scratch = pathlib.Path(scratch)
        for k in models:
            rng = random.Random(k)
            told = model(rng)
            for young in (5e7, 5e9):
                twin = None
                for integrator in ("implicit", "explicit", "partitioned"):
                    options = 'dt = "1 ms"' if integrator != "explicit" else 'dt = "auto"'
                    if integrator == "partitioned":
                        names = [b["name"] for b in blocks if b["name"] != "base-1"]
                        some = rng.sample(names, max(1, round(rng.uniform(0.3, 0.8) * len(names))))
                        options += f"\nexplicit_blocks = {json.dumps(some)}"
                    case = scratch / "case.toml"
                    case.write_text(CASE.format(young=young, integrator=integrator, options=options, **told))
                    allowed = 60.0 if twin is None else max(FLOOR, TIMES * twin)
                    run = Run(scree, case, scratch / "run", allowed)
                    what = f"model {k}, {young:g} Pa, {told['method']} {integrator}"
                    tally[integrator, run.code] = tally.get((integrator, run.code), 0) + 1
                    if twin is None:
                        twin, blocks = run.cpu, run.summary.get("blocks", [])
                    worst = max(worst, run.cpu / max(twin, FLOOR / TIMES))
                    print(f"{what}: {len(blocks)} blocks, code {run.code}, {run.cpu:.2f} s, twin {twin:.2f} s {run.err[:150]!r}", flush=True)
                    if run.code not in (0, 4):
                        fault(f"{what}: exit code {run.code} after {run.cpu:.1f} s: {run.err[:300]}")
                    elif run.code == 4 and ("audit" in run.err or "the rest has no source" in run.err):
                        fault(f"{what}: {run.err[:300]}")
                    if run.code == 0 and (FULL or k == first):
                        for threads in (2, 3):
                            again = Run(scree, case, scratch / "again", TIMES * run.cpu + FLOOR, threads)
                            if again.digest() != run.digest():
                                fault(f"{what}: {threads} threads give another state")
    print(f"{len(models)} models: {tally}; the worst took {worst:.1f} times its implicit twin; {len(faults)} faults")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
