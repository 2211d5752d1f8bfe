#!/usr/bin/python3
"""Every coupled feature under the address and undefined-behaviour sanitizers, or under valgrind.

Usage: memory_faults.py PROJECT asan|valgrind [--no-build]
Builds `scree` and `test_partition` in build/asan (preset asan) or build/dev (preset dev: valgrind does not know every
instruction of this machine), runs the cases below, short, and random partitions. A run must end with "done", and
the tool must find nothing. Exit code 77: valgrind is not installed.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

SKIPPED = 77
E2E = pathlib.Path(__file__).resolve().parent
CASES = E2E.parent.parent / "cases"
# Feature that a case covers, and the settings that shorten it: under valgrind a run takes some fifty times as long.
RUNS = {
    "a region through a resting block": (E2E / "memory/resting.toml", {}),
    "a region through a held block, shared contacts": (E2E / "memory/held.toml", {}),
    "no block explicit, after rest; steps of two sizes": (E2E / "memory/none.toml", {}),
    "a divided block, undivided before and after": (
        E2E / "resume/divided.toml", {"stage.0.duration": 0.002, "stage.1.duration": 0.01, "stage.2.duration": 0.002}),
    "blocks that change sides": (
        E2E / "resume/sides.toml",
        {"stage.0.duration": 0.006, "stage.1.duration": 0.05, "stage.2.duration": 0.01, "stage.3.duration": 0.002,
         "stage.4.duration": 0.002, "function.push.start": 0.02}),
    "stages of both methods": (E2E / "resume/staged.toml", {}),
    "blocks that change method by a rule": (E2E / "resume/rules.toml", {}),
    "motion of the base": (E2E / "resume/motion.toml", {}),
}
PARTITIONS = {"asan": 30, "valgrind": 10}


def build(project, preset):
    jobs = str(os.cpu_count())
    subprocess.run(["cmake", "--preset", preset, "-DSCREE_TESTS=ON"], cwd=project, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", "--preset", preset, "--parallel", jobs, "--target", "scree", "test_partition"],
                   cwd=project, check=True)


def tool(kind, project):
    """Words that precede a command, and its environment."""
    environment = dict(os.environ, OMP_NUM_THREADS="1", OMP_WAIT_POLICY="passive")
    if kind == "valgrind":
        return ["valgrind", "--quiet", "--error-exitcode=99", "--exit-on-first-error=no",
                f"--suppressions={project}/tests/valgrind.txt"], environment
    environment["UBSAN_OPTIONS"] = "halt_on_error=1:print_stacktrace=1"
    environment["LSAN_OPTIONS"] = f"suppressions={project}/tests/leaks.txt:print_suppressions=0"
    return [], environment


def main():
    if len(sys.argv) < 3 or sys.argv[2] not in ("asan", "valgrind"):
        print(__doc__.strip())
        return 2
    project, kind = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    if kind == "valgrind" and shutil.which("valgrind") is None:
        print("valgrind is not installed: apt-get install valgrind")
        return SKIPPED
    preset = "asan" if kind == "asan" else "dev"
    if "--no-build" not in sys.argv:
        build(project, preset)
    before, environment = tool(kind, project)
    folder, failed = project / "build" / preset, 0

    def run(what, command, extra=None):
        nonlocal failed
        begin = time.monotonic()
        done = subprocess.run(before + command, env=dict(environment, **(extra or {})), capture_output=True, text=True,
                              errors="replace")
        wrong = done.returncode != 0
        print(f"{'FAULT' if wrong else 'clean'}  {time.monotonic() - begin:6.1f} s  {what}", flush=True)
        if wrong:
            failed += 1
            print(f"  exit code {done.returncode}\n" + "\n".join((done.stdout + done.stderr).splitlines()[-60:]))
        return not wrong

    with tempfile.TemporaryDirectory(prefix="scree-memory-") as scratch:
        for i, (what, (case, settings)) in enumerate(RUNS.items()):
            out = pathlib.Path(scratch) / str(i)
            command = [str(folder / "app/scree"), "run", str(case), "--out", str(out), "--quiet"]
            for key, value in settings.items():
                command += ["--set", f"{key}={value}"]
            if run(what, command) and json.loads((out / "summary.json").read_text())["status"] != "done":
                print("FAULT  not done: " + what)
                failed += 1
    run(f"{PARTITIONS[kind]} random partitions", [str(folder / "tests/test_partition")],
        {"SCREE_PARTITIONS": str(PARTITIONS[kind])})
    return 1 if failed else 0


sys.exit(main())
