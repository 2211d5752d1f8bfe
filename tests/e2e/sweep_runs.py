#!/usr/bin/python3
"""Sweeps as a user makes them: the table, a sweep that is killed or stopped and goes on to the same table, wrong keys and values before any
run, runs that fail, and workflows for other programs.

Usage: sweep_runs.py SCREE
"""
import csv
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import h5py
import numpy as np

CASE = pathlib.Path(__file__).resolve().parent / "sweep" / "slide.toml"
ENVIRONMENT = dict(os.environ, OMP_WAIT_POLICY="passive")
GRID = ["--param", "joint.plane.friction_deg=5:40:8", "--jobs", "2"]
SHORT = ["--param", "joint.plane.friction_deg=10,20", "--until", "0.05"]
faults = 0


def expect(what, holds, shown=""):
    global faults
    faults += not holds
    print(f"  {'ok   ' if holds else 'FAULT'} {what}{'' if holds else ': ' + str(shown).strip()}", flush=True)


def sweep(*arguments, path=None, case=CASE):
    environment = dict(ENVIRONMENT, PATH=str(path)) if path else ENVIRONMENT
    done = subprocess.run([sys.argv[1], "sweep", str(case), *map(str, arguments)], capture_output=True, text=True, env=environment,
                          timeout=120)
    return done.returncode, done.stdout, done.stderr


def rows(folder):
    with open(folder / "sweep.csv") as file:
        return list(csv.DictReader(file))


def content(folder):
    """Every dataset and attribute of sweep.h5."""
    out = {}
    with h5py.File(folder / "sweep.h5") as file:
        out["@"] = dict(file.attrs)
        file.visititems(lambda name, item: out.update({name: (item[...] if isinstance(item, h5py.Dataset) else None, dict(item.attrs))}))
    return out


def same(a, b):
    def equal(x, y):
        if not isinstance(x, tuple):
            return repr(x) == repr(y)
        # assert_equal treats nan as equal to nan.
        return (x[0] is None) == (y[0] is None) and repr(x[1]) == repr(y[1]) and (x[0] is None or np.testing.assert_equal(x[0], y[0]) is None)

    try:
        return a.keys() == b.keys() and all(equal(a[name], b[name]) for name in a)
    except AssertionError:
        return False


def summaries(folder):
    return {p.parent.name: p.stat().st_mtime_ns for p in sorted(folder.glob("*/summary.json"))}


def begin(folder):
    """A sweep in a process group of its own, whose output goes to a file."""
    with open(f"{folder}.out", "w") as out:
        return subprocess.Popen([sys.argv[1], "sweep", str(CASE), *GRID, "--out", str(folder)], stdout=out, stderr=out, env=ENVIRONMENT,
                                start_new_session=True)


def half_way(process, folder, checkpoints):
    """Waits until three runs have ended and another has this number of its eight checkpoints, so that most of it is
    still to run."""
    until = time.monotonic() + 60
    while time.monotonic() < until and process.poll() is None:
        ended = set(summaries(folder))
        others = [p.parent for p in folder.glob("*/run.log") if p.parent.name not in ended]
        if len(ended) >= 3 and any(len(list(p.glob("checkpoint.*.scree"))) == checkpoints for p in others):
            return True
        time.sleep(0.002)
    return False


def whole(folder):
    code, out, err = sweep(*GRID, "--block", "slider", "--out", folder)
    expect("a sweep of eight runs is done", code == 0 and "8 of 8 runs are done" in out, (code, out, err))
    table = rows(folder)
    expect("a row a run, with units", [r["joint.plane.friction_deg [deg]"] for r in table] == [str(v) for v in range(5, 41, 5)], table)
    way = [float(r["centre.u [m]"]) for r in table]
    expect(f"less friction slides farther, 35 degrees stand: {way[0]:.3g} to {way[-1]:.3g} m",
           all(a > b for a, b in zip(way[:5], way[1:5])) and max(way[6:]) < 1e-3, way)
    expect("displacement of a block", [float(r["displacement.slider [m]"]) > 0 for r in table] == [True] * 8, table)
    expect("plots over the parameter", (folder / "plots" / "centre.u.svg").stat().st_size > 1000)
    numbers = content(folder)
    expect("the same in sweep.h5", np.array_equal(numbers["results/centre.u"][0], way) and numbers["results/centre.u"][1]["units"] == "m" and
           np.array_equal(numbers["parameters/joint.plane.friction_deg"][0], np.arange(5.0, 41.0, 5.0)), numbers.keys())
    made = summaries(folder)
    code, out, err = sweep(*GRID, "--block", "slider", "--out", folder)
    expect("the same command again makes no run", code == 0 and summaries(folder) == made, (code, out, err))
    shutil.copytree(folder, kept := folder.with_name("without-block"))
    expect("--collect makes the table alone", sweep(*GRID, "--out", kept, "--collect")[0] == 0 and summaries(kept) == made)
    return kept


def killed(folder, reference):
    process = begin(folder)
    expect("killed with three runs ended", half_way(process, folder, 1), pathlib.Path(f"{folder}.out").read_text())
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    ended = summaries(folder)
    expect(f"{len(ended)} of 8 runs had ended, and there is no table", len(ended) < 8 and not (folder / "sweep.csv").exists(), ended)
    code, out, err = sweep(*GRID, "--out", folder)
    expect("the same command goes on", code == 0 and "8 of 8 runs are done" in out, (code, out, err))
    now = summaries(folder)
    expect("runs that had ended were not made again", all(now[run] == at for run, at in ended.items()), (ended, now))
    resumed = [p.parent.name for p in folder.glob("*/run.log") if "goes on from" in p.read_text()]
    expect(f"runs with a checkpoint went on from it: {resumed}", resumed)
    expect("the table is that of an unbroken sweep, byte for byte", (folder / "sweep.csv").read_bytes() == (reference / "sweep.csv").read_bytes())
    expect("and so is sweep.h5", same(content(folder), content(reference)))


def stopped(folder, reference):
    process = begin(folder)
    expect("stopped with three runs ended", half_way(process, folder, 0), pathlib.Path(f"{folder}.out").read_text())
    process.send_signal(signal.SIGINT)
    code = process.wait(timeout=20)
    text = pathlib.Path(f"{folder}.out").read_text()
    expect("SIGINT ends it with 130 and says how to go on", code == 130 and "the same command goes on" in text and "scree" in text, (code, text))
    running = subprocess.run(["pgrep", "-g", str(process.pid)], capture_output=True, text=True).stdout.split()
    begun, done = len(list(folder.glob("logs/*.log"))), [json.loads(p.read_text())["status"] for p in folder.glob("*/summary.json")].count("done")
    expect(f"its runs end at once: {done} of {begun} begun are done", done < begun)
    expect("no run is left behind", not running, running)
    code, out, err = sweep(*GRID, "--out", folder)
    expect("and goes on to the same table", code == 0 and (folder / "sweep.csv").read_bytes() == (reference / "sweep.csv").read_bytes(), (code, out, err))


def refused(work, reference):
    out = work / "refused"
    code, _, err = sweep("--param", "joint.plane.fricton_deg=1,2", "--out", out)
    expect("a wrong key is refused before any run", code == 3 and err.startswith("--param:1:") and "friction_deg" in err and not out.exists(), (code, err))
    table = work / "runs.csv"
    table.write_text("joint.plane.friction_deg,stage.0.dt\n10,0.001\n95,0.001\n")
    code, _, err = sweep("--table", table, "--out", out)
    expect("a wrong value of the last row is refused at its place", code == 3 and err.startswith(f"{table}:3:1: error:") and "in run 2 of the sweep" in err and
           "allowed:" in err and not out.exists(), (code, err))
    table.write_text("joint.plane.friction_deg,stage.0.dt\n10\n")
    code, _, err = sweep("--table", table, "--out", out)
    expect("so is a row that is too short", code == 3 and err.startswith(f"{table}:2:1: error:") and not out.exists(), (code, err))
    code, _, err = sweep("--out", out)
    expect("a sweep of nothing is a wrong command", code == 2 and "--param" in err, (code, err))
    code, _, err = sweep("--param", "joint.plane.friction_deg=1,2", "--out", reference)
    expect("a folder that holds another sweep is refused", code == 5 and "holds another sweep" in err, (code, err))
    code, _, err = sweep(*SHORT, "--emit", "snakemak", work / "file", "--out", out)
    expect("a kind of workflow that there is not", code == 2 and 'did you mean "snakemake"' in err, (code, err))


def failing(folder):
    explicit = ["--set", 'stage.0.integrator="explicit"', "--until", "0.01"]
    code, out, err = sweep("--param", "stage.0.dt=auto,0.1", *explicit, "--out", folder)
    table = rows(folder)
    expect("a run that fails is reported, the others are done", code == 1 and [r["outcome"] for r in table] == ["done", "not_converged"] and
           "above the certified" in table[1]["reason"] and "above the certified" in err and "1 of 2 runs are done" in out, (code, out, err))
    first, made = (folder / "sweep.csv").read_bytes(), summaries(folder)
    code, _, _ = sweep("--param", "stage.0.dt=auto,0.1", *explicit, "--out", folder)
    expect("and is not made again", code == 1 and (folder / "sweep.csv").read_bytes() == first and summaries(folder) == made)


def program(folder, name, text):
    folder.mkdir(exist_ok=True)
    (folder / name).write_text(text)
    (folder / name).chmod(0o755)


def workflows(work):
    code, _, err = sweep(*SHORT, "--out", work / "local")
    expect("a short sweep is done", code == 0, err)
    table = (work / "local" / "sweep.csv").read_bytes()
    bin = f"{work / 'bin'}:{os.environ['PATH']}"
    # Substitutes for GNU parallel and Slurm: they start one run after the other.
    program(work / "bin", "parallel", '#!/bin/sh\nshift 3\nwhile read -r n; do "$1" "$2" "$n" || exit; done\n')
    program(work / "bin", "sbatch", """#!/bin/sh
for script; do :; done
case "$*" in *--wait*) echo 42 ;; *) echo "42;cluster"; exit ;; esac
first=$(sed -n 's/^#SBATCH --array=\\([0-9]*\\)-.*/\\1/p' "$script")
last=$(sed -n 's/^#SBATCH --array=[0-9]*-\\([0-9]*\\).*/\\1/p' "$script")
for n in $(seq "$first" "$last"); do SLURM_ARRAY_TASK_ID=$n sh "$script" || exit; done
""")
    code, out, err = sweep(*SHORT, "--out", work / "p", "--emit", "gnu-parallel", work / "jobs.sh", path=bin)
    expect("--emit gnu-parallel makes no run", code == 0 and not summaries(work / "p"), (code, out, err))
    done = subprocess.run(["sh", str(work / "jobs.sh")], cwd="/", env=dict(ENVIRONMENT, PATH=bin), capture_output=True, text=True)
    expect("its script makes the same table", done.returncode == 0 and (work / "p" / "sweep.csv").read_bytes() == table, done)
    code, out, err = sweep(*SHORT, "--out", work / "s", "--on", "slurm", path=bin)
    expect("a job array makes the same table", code == 0 and "job 42" in out and (work / "s" / "sweep.csv").read_bytes() == table, (code, out, err))
    code, out, err = sweep(*SHORT, "--out", work / "n", "--on", "slurm", "--no-wait", path=bin)
    expect("--no-wait says how to collect", code == 0 and "job 42 of" in out and "--collect" in out and not summaries(work / "n"), (code, out, err))
    code, out, err = sweep(*SHORT, "--out", work / "n", "--collect")
    expect("what is missing is reported", code == 1 and "absent" in err and [r["outcome"] for r in rows(work / "n")] == ["absent"] * 2, (code, out, err))
    code, out, err = sweep(*SHORT, "--out", work / "x", "--on", "slurm", path=work / "none")
    expect("without Slurm it says so", code == 5 and "needs the commands of Slurm" in err, (code, err))


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory(prefix="scree-sweep-") as name:
        work = pathlib.Path(name)
        reference = whole(work / "whole")
        killed(work / "killed", reference)
        stopped(work / "stopped", reference)
        refused(work, reference)
        failing(work / "failing")
        workflows(work)
    print(f"sweep_runs.py: {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
