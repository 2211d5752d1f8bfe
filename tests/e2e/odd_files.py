#!/usr/bin/python3
"""A named pipe, a device, a socket or a folder in place of a file: refused at once, with the path and what it is.

Usage: odd_files.py SCREE
"""
import os
import pathlib
import resource
import shutil
import socket
import subprocess
import sys
import tempfile

SCREE = sys.argv[1]
HERE = pathlib.Path(__file__).resolve().parent / "resume"
OF_RUNS = ["checkpoint.0.scree", "checkpoint.99.scree", "checkpoint.99.scree.tmp", "run.vtkhdf", "run.vtkhdf.new", "run.xmf",
           "history.csv", "energy.csv", "run.log", "summary.json", "summary.json.tmp"]
faults = []
commands = 0


def a_socket(path):
    place, before = socket.socket(socket.AF_UNIX), os.getcwd()
    os.chdir(path.parent)  # names of sockets are short
    place.bind(path.name)
    os.chdir(before)
    place.close()


KINDS = {"a named pipe": os.mkfifo, "a folder": os.mkdir, "a socket": a_socket,
         "a device": lambda path: path.symlink_to("/dev/zero")}


def refused(code, path, kind, *words):
    global commands
    commands += 1

    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))

    what = f"{kind} as {path.name}: {' '.join(map(str, words))}"
    try:
        done = subprocess.run([SCREE, *map(str, words)], capture_output=True, text=True, timeout=20, check=False,
                              preexec_fn=limit, stdin=subprocess.DEVNULL)
    except subprocess.TimeoutExpired:
        faults.append(what + ": hangs")
        return
    if done.returncode != code or path.name not in done.stderr or (code == 5 and kind not in done.stderr):
        faults.append(f"{what}: exit code {done.returncode}: {done.stderr.strip()}")


def test(scratch):
    whole = scratch / "whole"
    for name in ("motion.toml", "pulse.csv"):
        shutil.copy(HERE / name, scratch / name)
    case = scratch / "motion.toml"
    subprocess.run([SCREE, "run", str(case), "--out", str(whole), "--quiet", "--until", "0.02"], check=True)
    for kind, make in KINDS.items():
        for name in OF_RUNS:
            run = scratch / "run"
            shutil.rmtree(run, ignore_errors=True)
            shutil.copytree(whole, run)
            path = run / name
            path.unlink(missing_ok=True)
            make(path)
            refused(5, path, kind, "resume", run, "--quiet")
            if name.startswith("run.vtkhdf"):
                for words in (["watch", run], ["snapshot", run], ["replay", run]):
                    refused(5, path, kind, *words)
            if name != "run.vtkhdf":
                refused(5, path, kind, "run", case, "--out", run, "--overwrite", "--quiet")
        for name in ("motion.toml", "pulse.csv"):
            (scratch / name).unlink()
            make(scratch / name)
            refused(3, scratch / name, kind, "check", case)
            refused(3, scratch / name, kind, "run", case, "--out", scratch / "new")
            if (scratch / "new").exists():
                faults.append(f"{kind} as {name}: a folder was made")
            if name == "pulse.csv":
                refused(5, scratch / name, "", "resume", whole)
            if kind == "a folder":
                (scratch / name).rmdir()
            else:
                (scratch / name).unlink()
            shutil.copy(HERE / name, scratch / name)


with tempfile.TemporaryDirectory(prefix="scree-odd-") as folder:
    test(pathlib.Path(folder))
for text in faults:
    print("FAULT: " + text)
print(f"{commands} commands, {len(faults)} faults")
sys.exit(1 if faults else 0)
