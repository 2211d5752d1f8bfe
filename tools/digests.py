#!/usr/bin/python3
"""Whether a change of the program changed a result: digests of all cases before, and after.

Usage: digests.py store FOLDER [--scree SCREE]      one file a case and number of threads
       digests.py compare FOLDER [--scree SCREE]    the same runs again; differences, and how large they are

A digest (`scree digest`) has a line for each frame: a hash of time, step, positions, velocities, accelerations, contacts and ledger, and norms and
sums of them. Equal lines are equal to the last bit. Where sums change their order, `compare --tolerance 1e-10` lets numbers differ
by that much of the largest of their column, and contact states not at all.
"""
import argparse
import csv
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Cases that are run only up to this time [s]. Folders without a case file are studies.
UNTIL = {"jinping": 0.1, "collapse": 0.02, "staged-slope": 0.45}
SCENES = ["digging", "divided", "kept", "motion", "rules", "sides", "sleep", "staged", "tangent"]
EXACT = {"step", "stage", "open", "slip", "stick"}


def runs():
    for case in sorted(ROOT.glob("cases/*/*.toml")):
        if case.name != "expected.toml":
            yield f"{case.parent.name}-{case.stem}", case, UNTIL.get(case.parent.name)
    for name in SCENES:
        yield f"scene-{name}", ROOT / f"tests/e2e/resume/{name}.toml", None


def digest(scree, case, until, threads):
    command = [scree, "digest", case, "--threads", str(threads), *(["--until", str(until)] if until else [])]
    done = subprocess.run(command, capture_output=True, text=True, env=dict(os.environ, OMP_WAIT_POLICY="passive"))
    return done.stdout if done.returncode == 0 else f"exit code {done.returncode}\n{done.stderr}"


def differences(before, after):
    """Compares two digests: whether steps or contact states differ, and the largest relative difference of a number."""
    a, b = (list(csv.DictReader(text.splitlines())) for text in (before, after))
    if len(a) != len(b) or (a and a[0].keys() != b[0].keys()):
        return True, float("inf")
    largest, states = 0.0, False
    for column in (a[0].keys() if a else []):
        if column == "hash":
            continue
        if column in EXACT:
            states = states or any(x[column] != y[column] for x, y in zip(a, b))
            continue
        scale = max(max(abs(float(x[column])) for x in a), 1e-300)
        largest = max(largest, max(abs(float(x[column]) - float(y[column])) for x, y in zip(a, b)) / scale)
    return states, largest


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["store", "compare"])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--scree", type=pathlib.Path, default=ROOT / "build/release/app/scree")
    parser.add_argument("--tolerance", type=float, default=0.0)
    parser.add_argument("--only", nargs="+", help="runs whose name holds one of these")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    wrong = count = 0
    for name, case, until in runs():
        if options.only and not any(part in name for part in options.only):
            continue
        for threads in (1, 2):
            file = options.folder / f"{name}-{threads}.csv"
            now = digest(options.scree, case, until, threads)
            count += 1
            if options.what == "store":
                file.write_text(now)
                print(f"{file.name}: {max(len(now.splitlines()) - 1, 0)} frames", flush=True)
                continue
            before = file.read_text() if file.exists() else ""
            if now == before:
                continue
            states, largest = differences(before, now)
            fine = not states and largest <= options.tolerance
            wrong += not fine
            print(f"{file.name}: numbers differ by {largest:.1e}" + (", and steps or contact states" if states else ""), flush=True)
    if options.what == "compare":
        print(f"{count} digests compared, {wrong} differ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
