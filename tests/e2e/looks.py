#!/usr/bin/python3
"""A run is independent of output, streams and pieces: the hash of its last state does not depend on [output], on
[live], on checkpoints, on --audit, or on its division into pieces by --until and `scree resume`.

Usage: looks.py SCREE [CASE ...]
Each of 40 settings is used once, distributed over the cases; with SCREE_FULL=1 in the environment every case runs with
all 40.
"""
import json
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
FULL = bool(os.environ.get("SCREE_FULL"))
ENVIRONMENT = dict(os.environ, OMP_WAIT_POLICY="passive", OMP_NUM_THREADS="1")
# The feature that each case covers.
CASES = {
    "resume/staged": "rest, explicit, implicit NMM, cut implicit DDA, onefold, explicit DDA",
    "resume/kept": "implicit DDA, implicit rest to a balance of forces",
    "resume/motion": "explicit NMM and DDA on a ground that moves",
    "resume/sides": "implicit NMM, partitioned with rules, explicit steps of two sizes",
    "resume/divided": "partitioned through a block",
    "resume/rules": "stages that end by rules, blocks that change method",
    "looks/trapezoid": "trapezoidal and damped steps, loads that begin with stages",
    "looks/shaken": "explicit rest that ends early, a motion that begins with the stage after it",
}


def settings():
    """40 settings: values of --set, and the number of pieces."""
    rng = random.Random(7)
    out = [
        dict(set=["output.every=1e-3", "output.history_every=1e-3"]),
        dict(set=["output.every=0.5", "output.history_every=0.5"]),
        dict(set=["output.every=0.0137", "output.history_every=0.00071"]),
        dict(set=["output.history_every=3.3e-4"]),
        dict(set=["output.contacts=true", "output.every=7e-3"]),
        dict(set=["output.checkpoint_steps=7"]),
        dict(set=["output.checkpoint_every=0", "output.checkpoint_steps=0"]),
        dict(set=["live.enabled=true", 'live.url="memq://"', "live.rate=1000"]),
        dict(set=["live.enabled=true", 'live.url="memq://"', "live.rate=1", "output.every=2.5e-3"]),
        dict(set=[], audit=True),
        dict(set=["output.history_every=9e-4"], audit=True),
        dict(set=["run.max_closure=1e-3", "output.history_every=2.1e-3"]),
        dict(set=[], pieces=2),
        dict(set=[], pieces=5),
        dict(set=["output.checkpoint_steps=11"], pieces=3),
    ]
    while len(out) < 40:
        every = 10 ** rng.uniform(-3.0, -0.5)
        one = dict(set=[f"output.every={every:.6g}", f"output.history_every={every * 10 ** rng.uniform(-1.0, 0.0):.6g}"])
        if rng.random() < 0.3:
            one["set"].append(f"output.checkpoint_steps={rng.randint(1, 90)}")
        if rng.random() < 0.3:
            one["set"] += ["live.enabled=true", 'live.url="memq://"', f"live.rate={rng.choice((3, 30, 300))}"]
        if rng.random() < 0.4:
            one["pieces"] = rng.randint(2, 5)
        if rng.random() < 0.2:
            one["audit"] = True
        out.append(one)
    return out


def scree(program, *arguments):
    done = subprocess.run([program, *map(str, arguments), "--quiet"], capture_output=True, text=True, env=ENVIRONMENT,
                          timeout=600)
    if done.returncode != 0:
        sys.exit(f"scree {' '.join(map(str, arguments))}: exit code {done.returncode}: {done.stderr.strip()}")


def result(run):
    summary = json.loads((run / "summary.json").read_text())
    return summary["state_hash"], summary["steps"], summary["final_time"]


def looked_at(program, case, how, folder, end, seed):
    """The end of a run with one of the settings."""
    shutil.rmtree(folder, ignore_errors=True)
    rng = random.Random(seed)
    stops = sorted(rng.uniform(0.0, end) for _ in range(how.get("pieces", 1) - 1))
    options = [part for each in how["set"] for part in ("--set", each)] + (["--audit"] if how.get("audit") else [])
    first = ["--until", f"{stops[0]:.9g}"] if stops else []
    scree(program, "run", HERE / f"{case}.toml", "--out", folder, *options, *first)
    for stop in [f"{s:.9g}" for s in stops[1:]] + (["1e6"] if stops else []):
        if json.loads((folder / "summary.json").read_text())["final_time"] > float(stop):
            continue  # the previous step has already passed this time
        scree(program, "resume", folder, "--until", stop)
    return result(folder)


def told(how):
    text = " ".join(s.replace("output.", "").replace('live.url="memq://"', "").replace("live.enabled=true", "live")
                    for s in how["set"])
    text += f" {how['pieces']} pieces" if how.get("pieces") else ""
    return " ".join((text + (" audit" if how.get("audit") else "")).split())


def main():
    program, *wanted = sys.argv[1:]
    cases = wanted or list(CASES)
    ways = settings()
    assert len(ways) == 40
    faults = tried = 0
    with tempfile.TemporaryDirectory(prefix="scree-looks-") as scratch:
        whole, run = pathlib.Path(scratch) / "whole", pathlib.Path(scratch) / "run"
        for c, case in enumerate(cases):
            shutil.rmtree(whole, ignore_errors=True)
            scree(program, "run", HERE / f"{case}.toml", "--out", whole)
            expected = result(whole)
            print(f"{case}: {CASES.get(case, '')}\n  {expected[0]}  {expected[1]} steps to {expected[2]:.6g} s", flush=True)
            for k, how in enumerate(ways):
                if not FULL and k % len(cases) != c:
                    continue
                found = looked_at(program, case, how, run, expected[2], k)
                tried += 1
                same = found == expected
                faults += not same
                print(f"  {found[0]}  {found[1]} steps  {'same' if same else 'FAULT'}  {told(how)}", flush=True)
    print(f"{tried} runs looked at in {len(ways)} ways, {faults} faults")
    sys.exit(1 if faults or (FULL and tried != 40 * len(cases)) else 0)


if __name__ == "__main__":
    main()
