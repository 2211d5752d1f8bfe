#!/usr/bin/python3
"""Runs that are killed, stopped or run out of disk space, and are resumed: their results must equal those of the
uninterrupted run.

Usage: resume_runs.py SCREE kill|stop|files [CASE ...]
Few interruptions by default; SCREE_FULL=1 in the environment: long form. Exit code 77: not possible on this machine.
"""
import functools
import json
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import h5py
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent / "resume"
FULL = bool(os.environ.get("SCREE_FULL"))
ENVIRONMENT = dict(os.environ, OMP_WAIT_POLICY="passive", OMP_NUM_THREADS="1")
SKIPPED = 77
# Entries of a summary that depend on the machine and its clock, or on the command line of the run.
OF_THE_CLOCK = {"wall_seconds", "cpu_seconds", "cpu_seconds_of", "peak_memory_bytes", "element_steps_per_second", "threads",
                "command_line", "set"}

# Instants of interruption after which a resumed run once differed: here the incomplete factor has just replaced the
# complete one.
CUTS = {"rules": ("0.0596", "0.0605", "0.0615")}

faults = []


def fault(text):
    faults.append(text)
    print("  FAULT: " + text, flush=True)


def summary(run):
    return json.loads((run / "summary.json").read_text())


@functools.lru_cache(maxsize=2)
def datasets(path, written):
    """Every dataset and attribute but those of /provenance, of a file written then."""
    out = {}
    with h5py.File(path) as file:
        def visit(name, item):
            if name.startswith("provenance"):
                return
            if isinstance(item, h5py.Dataset):
                out[name] = item[...]
            if not name.startswith("xdmf/"):  # thousands of virtual datasets, with the labels of their sources
                for key, value in item.attrs.items():
                    out[f"{name}@{key}"] = np.asarray(value)
        file.visititems(visit)
    return out


def differences(run, whole):
    """Differences between two finished runs."""
    found = []
    a, b = summary(run), summary(whole)
    found += [f"summary.json: {k} is {a.get(k)!r:.60}, not {b.get(k)!r:.60}"
              for k in sorted(set(a) | set(b)) if k not in OF_THE_CLOCK and a.get(k) != b.get(k)]
    for name in ("history.csv", "energy.csv"):
        if (run / name).read_bytes() != (whole / name).read_bytes():
            found.append(f"{name} differs")
    if list(run.glob("run.damaged*")):
        return found  # run.vtkhdf begins where the run was resumed
    if (run / "run.xmf").read_bytes() != (whole / "run.xmf").read_bytes():
        found.append("run.xmf differs")
    a, b = (datasets(path, path.stat().st_mtime_ns) for path in (run / "run.vtkhdf", whole / "run.vtkhdf"))
    for name in sorted(set(a) | set(b)):
        if name not in a or name not in b or a[name].shape != b[name].shape or a[name].tobytes() != b[name].tobytes():
            if name in a and name in b and a[name].dtype == object and list(a[name]) == list(b[name]):
                continue  # texts are compared as texts
            found.append(f"/{name} differs")
    return found


class Scree:
    def __init__(self, program):
        self.program = program

    def start(self, *arguments, limit=None):
        def before():
            if limit is not None:
                resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
        return subprocess.Popen([self.program, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                text=True, env=ENVIRONMENT, preexec_fn=before)

    def __call__(self, *arguments, limit=None):
        process = self.start(*arguments, limit=limit)
        out, err = process.communicate(timeout=600)
        return process.returncode, out, err


def cpu_seconds(process):
    """Processor time of a process that has not been waited for yet [s]."""
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def cpu_of_children():
    """Processor time of all child processes that have been waited for [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def checkpoints(run):
    return sorted(run.glob("checkpoint.*.scree"))


def finish(scree, run, again, what):
    """Resumes until the run is done; a run without a checkpoint must report that, and is started again."""
    code, _, err = scree("resume", run, "--quiet")
    if code == 5 and not checkpoints(run) and ("there is no checkpoint in it" in err or "no such run folder" in err):
        code, _, err = scree(*again, "--overwrite")
    if code != 0:
        fault(f"{what}: exit code {code}: {err.strip()}")
        return False
    return True


def unbroken(scree, case, folder):
    begin = time.time()
    code, _, err = scree("run", HERE / f"{case}.toml", "--out", folder, "--quiet")
    assert code == 0, err
    return time.time() - begin


def kill(scree, case, scratch, rng):
    whole = scratch / "whole"
    seconds = unbroken(scree, case, whole)
    count = 100 if FULL else 4
    tally = dict(kills=0, early=0, writing=0, twice=0)
    for k in range(count):
        run = scratch / "run"
        shutil.rmtree(run, ignore_errors=True)
        # Checkpoints take most of the time if written every 10 steps, and little if written every 100.
        steps = 10 if k % 3 == 0 else 100
        ask = ["run", HERE / f"{case}.toml", "--out", run, "--quiet", "--set", f"output.checkpoint_steps={steps}"]
        if k == 0:
            begin = time.time()
            assert scree(*ask)[0] == 0
            slow = time.time() - begin
            for line in differences(run, whole):
                fault(f"{case}, not killed, with checkpoints: {line}")
            shutil.rmtree(run)
        command = ask
        for attempt in range(rng.choice((1, 1, 2, 3))):
            process = scree.start(*command)
            time.sleep(rng.uniform(0.0, 1.05 * (slow if steps == 10 else seconds + 0.1 * slow)))
            process.kill()
            process.communicate()
            tally["kills"] += 1
            tally["twice"] += attempt > 0
            if list(run.glob("checkpoint*.tmp")):
                tally["writing"] += 1
            if not checkpoints(run):
                tally["early"] += 1
                break
            command = ["resume", run, "--quiet"]
        if not finish(scree, run, ask, f"{case}, kill {k}"):
            continue
        if list(run.glob("run.damaged*")):
            fault(f"{case}, kill {k}: run.vtkhdf was put aside")
        for line in differences(run, whole):
            fault(f"{case}, kill {k}: {line}")
    print(f"{case}: unbroken {seconds:.2f} s, {slow:.2f} s with a checkpoint every 10 steps; {count} runs: {tally}", flush=True)


def stop(scree, case, scratch, rng):
    whole = scratch / "whole"
    seconds = unbroken(scree, case, whole)
    longest = 0.0
    stopped = 0
    for k in range(40 if FULL else 4):
        run = scratch / "run"
        shutil.rmtree(run, ignore_errors=True)
        ask = ["run", HERE / f"{case}.toml", "--out", run, "--quiet"]
        process = scree.start(*ask)
        while not checkpoints(run):
            time.sleep(0.002)
        time.sleep(rng.uniform(0.0, seconds))
        begin = cpu_of_children() + cpu_seconds(process)
        process.send_signal(rng.choice((signal.SIGTERM, signal.SIGINT)))
        _, err = process.communicate(timeout=60)
        took = cpu_of_children() - begin  # processor time, since other programs use the machine, too
        if process.returncode == 0:
            continue  # it was done already
        stopped += 1
        longest = max(longest, took)
        if process.returncode != 130 or f"scree resume {run}" not in err:
            fault(f"{case}, stop {k}: exit code {process.returncode}: {err.strip()}")
        if took > 1.0:
            fault(f"{case}, stop {k}: took {took:.2f} s of processor time")
        if summary(run)["status"] != "interrupted":
            fault(f"{case}, stop {k}: the summary says {summary(run)['status']}")
        if finish(scree, run, ask, f"{case}, stop {k}"):
            for line in differences(run, whole):
                fault(f"{case}, stop {k}: {line}")
    for cut in CUTS.get(case, ()):
        run = scratch / "run"
        shutil.rmtree(run, ignore_errors=True)
        scree("run", HERE / f"{case}.toml", "--out", run, "--quiet", "--until", cut)
        code, _, err = scree("resume", run, "--quiet", "--until", "100")
        if code != 0:
            fault(f"{case}, cut at {cut} s: exit code {code}: {err.strip()}")
        if summary(run)["state_hash"] != summary(whole)["state_hash"] or summary(run)["corrections"] != summary(whole)["corrections"]:
            fault(f"{case}, cut at {cut} s: ends otherwise than the unbroken run")
    # For every checkpoint of a run: if the newest is damaged, the previous one is used, with a message.
    run = scratch / "run"
    shutil.rmtree(run, ignore_errors=True)
    scree("run", HERE / f"{case}.toml", "--out", run, "--quiet", "--set", "output.checkpoint_steps=40")
    newest = max(checkpoints(run), key=lambda path: int(path.name.split(".")[1]))
    newest.write_bytes(newest.read_bytes()[:-7])
    code, _, err = scree("resume", run, "--quiet")
    if code != 0 or "warning: " + str(newest) not in err:
        fault(f"{case}, damaged newest checkpoint: exit code {code}: {err.strip()}")
    for line in differences(run, whole):
        fault(f"{case}, damaged newest checkpoint: {line}")
    # run.vtkhdf is lost: the state is still resumed.
    (run / "run.vtkhdf").write_bytes(b"nothing")
    (run / "history.csv").write_bytes(b"less")
    code, _, err = scree("resume", run, "--quiet")
    if code != 0 or "run.damaged.vtkhdf" not in err or summary(run)["state_hash"] != summary(whole)["state_hash"]:
        fault(f"{case}, damaged run.vtkhdf: exit code {code}: {err.strip()}")
    (run / "run.vtkhdf").unlink()
    (run / "energy.csv").unlink()
    code, _, err = scree("resume", run, "--quiet")
    if code != 0 or "is missing" not in err or summary(run)["state_hash"] != summary(whole)["state_hash"]:
        fault(f"{case}, lost run.vtkhdf: exit code {code}: {err.strip()}")
    # Two runs at once, and two signals.
    process = scree.start("run", HERE / f"{case}.toml", "--out", scratch / "two", "--quiet")
    while not checkpoints(scratch / "two"):
        time.sleep(0.002)
    code, _, err = scree("resume", scratch / "two")
    if process.poll() is None and (code != 5 or "another run" not in err):
        fault(f"{case}, resumed while it runs: exit code {code}: {err.strip()}")
    process.send_signal(signal.SIGINT)
    process.send_signal(signal.SIGINT)
    process.communicate()
    if process.returncode not in (130, 0):
        fault(f"{case}, two signals: exit code {process.returncode}")
    if "pulse.csv" in (HERE / f"{case}.toml").read_text():
        copy = scratch / "case"
        shutil.copytree(HERE, copy)
        moved = scratch / "moved"
        scree("run", copy / f"{case}.toml", "--out", moved, "--quiet", "--until", "0.05")
        with (copy / "pulse.csv").open("a") as file:
            file.write("0.1025, 0.0\n")
        code, _, err = scree("resume", moved, "--until", "0.1")
        if code != 5 or "pulse.csv" not in err or "has changed" not in err:
            fault(f"{case}, changed record: exit code {code}: {err.strip()}")
        (copy / "pulse.csv").unlink()
        code, _, err = scree("resume", moved, "--until", "0.1")
        if code != 5 or "pulse.csv" not in err or "does not exist" not in err:
            fault(f"{case}, missing record: exit code {code}: {err.strip()}")
    print(f"{case}: {stopped} stopped, the slowest in {longest:.3f} s of processor time", flush=True)


def went_on(scree, case, run, whole, ask, what, outcome, reason, tally):
    """A run that could not write: its message, and its continuation once writing is possible."""
    code, _, err = outcome
    if code == 0:
        fault(f"{what}: exit code 0")
    elif code != 5 or not re.search(re.escape(str(run)) + r"[^:]*: .*(" + reason + ")", err):
        fault(f"{what}: exit code {code}: {err.strip()}")
    if checkpoints(run) and "scree resume" not in err:
        fault(f"{what}: nothing says how to go on: {err.strip()}")
    if (run / "summary.json").exists() and summary(run)["status"] == "done":
        fault(f"{what}: the summary says it is done")
    tally["resumed"] += bool(checkpoints(run))
    if finish(scree, run, [*ask, run], what):
        tally["damaged"] += bool(list(run.glob("run.damaged*")))
        for line in differences(run, whole):
            fault(f"{what}: {line}")


def files(scree, case, scratch, rng):
    if "SCREE_IN_NAMESPACE" not in os.environ:
        enter = ["unshare", "-m"] if os.getuid() == 0 else ["unshare", "-rm"]
        probe = scratch / "probe"
        probe.mkdir()
        try:
            able = subprocess.run(enter + ["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", probe],
                                  capture_output=True, check=False).returncode == 0
        except FileNotFoundError:
            able = False
        if not able:
            print("SKIPPED: mounting in a namespace is not allowed here")
            sys.exit(SKIPPED)
        os.environ["SCREE_IN_NAMESPACE"] = "1"
        shutil.rmtree(scratch)
        os.execvp(enter[0], enter + [sys.executable, *sys.argv])
    whole = scratch / "whole"
    unbroken(scree, case, whole)
    ask = ["run", HERE / f"{case}.toml", "--quiet", "--set", "output.checkpoint_steps=50", "--out"]
    tally = dict(limits=0, disks=0, resumed=0, damaged=0)

    # The limit on the file size is reached at a different write each time: at the beginning, where files grow, ...
    begin = time.time()
    assert scree(*ask, scratch / "timed")[0] == 0
    slow = time.time() - begin
    largest = max(f.stat().st_size for f in whole.iterdir())
    places = 30 if FULL else 8
    limits = sorted({int(1 + (largest - 1) * (k / places) ** 3) for k in range(places)})
    run = scratch / "limited"
    for limit in limits:
        shutil.rmtree(run, ignore_errors=True)
        tally["limits"] += 1
        went_on(scree, case, run, whole, ask, f"{case}, files of at most {limit} bytes", scree(*ask, run, limit=limit),
                "File too large", tally)
    # ... and of a run that is going on.
    for k in range(30 if FULL else 4):
        shutil.rmtree(run, ignore_errors=True)
        process = scree.start(*ask, run)
        time.sleep(rng.uniform(0.02, slow))
        limit = rng.choice((1, 1000, 20000, 100000))
        resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (limit, limit))
        out, err = process.communicate()
        if process.returncode == 0:
            continue  # the run was done, or there was nothing more to write
        tally["limits"] += 1
        went_on(scree, case, run, whole, ask, f"{case}, limit {k}", (process.returncode, out, err), "File too large", tally)

    # A disk that is full from the start, and one that another program fills during the run. Then space is freed.
    disk = scratch / "disk"
    disk.mkdir()
    run = disk / "run"
    for k in range(30 if FULL else 4):
        size = 4096 * (1 + k * 40) if k % 2 == 0 else 64 << 20
        subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", disk], check=True)
        process = scree.start(*ask, run)
        if k % 2 == 1:
            time.sleep(rng.uniform(0.02, slow))
            with (disk / "filler").open("wb", buffering=0) as filler:
                try:
                    for block in (1 << 20, 4096):
                        while filler.write(bytes(block)) == block:
                            pass
                except OSError:
                    pass
        out, err = process.communicate()
        (disk / "filler").unlink(missing_ok=True)
        subprocess.run(["mount", "-o", f"remount,size={64 << 20}", disk], check=True)
        if process.returncode != 0:
            tally["disks"] += 1
            went_on(scree, case, run, whole, ask, f"{case}, full disk {k}", (process.returncode, out, err),
                    "No space left", tally)
        subprocess.run(["umount", disk], check=True)

    # Folders without write access: refused before the first step.
    disk = scratch / "readonly"
    disk.mkdir()
    subprocess.run(["mount", "-t", "tmpfs", "-o", "ro", "tmpfs", disk], check=True)
    taken = scratch / "taken"
    taken.write_text("a file")
    for out in (disk, disk / "run", taken, taken / "run", pathlib.Path("/proc/nowhere")):
        code, _, err = scree(*ask, out)
        if code != 5 or str(out) not in err or "stage_start" in err:
            fault(f"{case}, --out {out}: exit code {code}: {err.strip()}")
    shutil.copytree(whole, scratch / "old")
    for run, says in ((scratch / "none", "no such run folder"), (taken, "is not a folder"), (HERE, "no checkpoint")):
        code, _, err = scree("resume", run)
        if code != 5 or says not in err:
            fault(f"resume {run}: exit code {code}: {err.strip()}")
    subprocess.run(["umount", disk], check=True)
    print(f"{case}: {tally}", flush=True)


def main():
    scree, mode, *cases = sys.argv[1:]
    action = {"kill": kill, "stop": stop, "files": files}[mode]
    for case in cases or ["staged", "kept", "motion", "sides", "divided", "rules", "digging"]:
        with tempfile.TemporaryDirectory(prefix="scree-resume-") as scratch:
            action(Scree(scree), case, pathlib.Path(scratch), random.Random(20260 + len(case)))
    print(f"{len(faults)} faults")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
