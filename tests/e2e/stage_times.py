#!/usr/bin/python3
"""Times relative to stages: the earthquake acts in its stage although the previous one came to rest early, times that
no stage can reach are refused, and a stage that does not come to rest reports why.

Usage: stage_times.py SCREE
"""
import csv
import os
import pathlib
import re
import subprocess
import sys
import tempfile

CASE = pathlib.Path(__file__).resolve().parent / "looks" / "shaken.toml"
ENVIRONMENT = dict(os.environ, OMP_WAIT_POLICY="passive", OMP_NUM_THREADS="1")
faults = 0


def scree(*arguments):
    done = subprocess.run([sys.argv[1], *map(str, arguments)], capture_output=True, text=True, env=ENVIRONMENT, timeout=300)
    return done.returncode, done.stdout, done.stderr


def run(folder, *sets):
    return scree("run", CASE, "--out", folder, "--overwrite", *[part for s in sets for part in ("--set", s)])


def expect(what, holds, shown=""):
    global faults
    faults += not holds
    print(f"  {'ok   ' if holds else 'FAULT'} {what}{'' if holds else ': ' + str(shown).strip()}", flush=True)


def rows(folder, name):
    with open(folder / name) as file:
        table = csv.reader(line for line in file if not line.startswith("#"))
        names = [name.split(" [")[0] for name in next(table)]  # without units
        return [dict(zip(names, row)) for row in table]


def stage_begins(folder):
    """From run.log, by stage."""
    found = re.findall(r"t = (\S+) s  stage_start  stage '([^']+)'", (folder / "run.log").read_text())
    return {name: float(time) for time, name in found}


def struck(folder, what, after, length):
    """Work of the moving base begins after the given time, and within the given interval."""
    begins = stage_begins(folder)
    work = [(float(r["time"]), abs(float(r["prescribed_motion"]))) for r in rows(folder, "energy.csv")]
    # A base that only supports the block does no work except during its settling: compare with the end of the rest
    # stage.
    at_rest = max(w for t, w in work if t <= begins["shaking"])
    first = min((t for t, w in work if w > at_rest + 0.1), default=float("inf"))
    expect(f"{what}: rest ends at {begins['shaking']:.4g} s of 2, work of the base from {first:.4g} s on, "
           f"{work[-1][1] - at_rest:.3g} J",
           begins["shaking"] < 1.5 and begins["shaking"] + after < first < begins["shaking"] + after + length)


def motions(folder):
    code, _, err = run(folder)
    expect("a motion without start", code == 0, err)
    struck(folder, "a motion without start", 0.0, 0.03)
    code, _, err = run(folder, 'motion.quake.start="shaking"', "motion.quake.offset=0.04", "stage.1.duration=0.2")
    expect("a motion with the name of a stage and an offset", code == 0, err)
    struck(folder, "an offset of 0.04 s", 0.04, 0.03)
    code, out, err = run(folder, "motion.quake.start=2.0")
    expect("a motion on the clock that an early rest leaves behind is refused by the run", code == 3 and
           "the motion 'quake' begins at 2 s, but the run is over at" in err and "it acts in no stage" in err and
           'start = "shaking"' in err, (code, err))
    code, out, err = run(folder, "motion.quake.start=2.0", "stage.2.duration=4", "stage.2.dt=0.02")
    expect("one that now strikes another stage is warned of", code == 0 and
           "begins in stage 'after', not in 'shaking' as planned" in out, (code, out, err))
    for command in ("check", "run"):
        options = ["--out", folder / "no"] if command == "run" else []
        code, _, err = scree(command, CASE, "--set", 'motion.quake.start="shakin"', *options)
        expect(f"scree {command} refuses the name of no stage", code == 3 and "no stage of that name" in err and
               'did you mean "shaking"' in err, (code, err))
        code, _, err = scree(command, CASE, "--set", "motion.quake.start=9", *options)
        expect(f"scree {command} refuses a motion after the end", code == 3 and "it acts in no stage" in err, (code, err))
    code, out, err = scree("check", CASE, "--set", "stage.1.duration=0.03", "--set", "stage.2.duration=0.02")
    expect("scree check warns of a motion that outlasts the run", code == 0 and
           "warning: the motion 'quake' goes on until 2.06 s, but the run is over at 2.05 s" in out, (code, out, err))
    code, out, err = scree("check", CASE)
    expect("and of no other", code == 0 and "warning" not in out, out)


def rests(folder):
    slides = ["model.gravity=[6, -8]", "joint.joint.friction_deg=15", "stage.0.damping=0", "stage.0.duration=0.5"]
    for method, more in (("explicit", []), ("implicit", ['stage.0.integrator="implicit"', "stage.0.dt=0.01"])):
        code, out, err = run(folder, *slides, *more)
        expect(f"{method}: a block that slides is named", code == 4 and "'block' slides, and does not slow down" in err,
               (code, out, err))
        expect(f"{method}: and how the unbalanced force falls", "the least unbalanced force was" in err, err)
        expect(f"{method}: once", (out + err).count("not at rest after") == 1, out + err)
    # The message states the reason: kinetic damping needs 0.1 s and more.
    short = ["stage.0.duration=0.004", "motion.quake.start=0.004"]
    text = CASE.read_text().replace("rest_force = 1e-3\n", "")
    case = folder.parent / "short.toml"
    case.write_text(text.replace('file = "pulse.csv"', f'file = "{CASE.parent / "pulse.csv"}"'))
    code, out, err = scree("run", case, "--out", folder, "--overwrite", *[p for s in short for p in ("--set", s)])
    expect("without rest_force a stage that is not at rest warns and goes on", code == 0 and
           re.search(r"stage 'gravity' ends before it is at rest: block 'block' has an unbalanced force of \S+ N, "
                     r"\S+ of the largest force", out) is not None, (code, out, err))
    code, out, err = scree("run", case, "--out", folder, "--overwrite")
    expect("and one that is does not", code == 0 and "before it is at rest" not in out, (code, out, err))


def main():
    with tempfile.TemporaryDirectory(prefix="scree-times-") as scratch:
        motions(pathlib.Path(scratch) / "run")
        rests(pathlib.Path(scratch) / "run")
    print(f"{faults} faults")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
