#!/usr/bin/python3
"""Runs that cannot continue: the error message, the exit code, and the results stored until then.

Usage: lost_runs.py SCREE
"""
import pathlib
import re
import subprocess
import sys
import tempfile

import h5py
import numpy as np

PLACE = r"element \d+ near \(-?[\d.e+-]+, -?[\d.e+-]+\)"
# case: exit code, status in the results, required text of the error, and time of the last good frame
RUNS = {
    "inverted_explicit": (4, "non_finite", ["block 'victim'", PLACE + " is turned inside out", "likely causes: loads"], None),
    "inverted_implicit": (4, "not_converged", ["block 'victim'", PLACE + " is turned inside out", "likely causes: loads"], None),
    "not_finite_explicit": (4, "non_finite", ["block 'a'", r"near \(", "not finite", "likely causes"], None),
    "not_finite_implicit": (4, "non_finite", ["block 'a'", "load is not finite", "likely causes"], 0.005),
    "step_at_start": (3, "not_converged", ["block 'victim'", PLACE, "above the certified stable one", 'dt = "auto"'], 0.0),
    "step_in_second_stage": (3, "not_converged", ["stage 'second'", "block 'faller'", PLACE, "above the certified"], 0.1),
    "step_on_contact": (3, "not_converged", ["block 'faller'", "contacts, the stiffest with block 'floor'", "above the certified"], None),
    "unsupported_explicit": (4, "not_converged", ["block 'hanging'", "no path of closed contacts", "likely causes"], 0.05),
    "unsupported_implicit": (4, "not_converged", ["block 'hanging'", "no path of closed contacts", "likely causes"], 0.05),
}


def not_finite(file):
    names = []

    def visit(name, item):
        if isinstance(item, h5py.Dataset) and item.dtype.kind == "f" and not np.isfinite(item[...]).all():
            names.append(name)

    file.visititems(visit)
    return names


def faults_of(scree, case, out, wanted):
    code, status, says, last = wanted
    done = subprocess.run([scree, "run", str(case), "--out", str(out), "--quiet", "--set", "run.max_gain=0"], capture_output=True, text=True, timeout=200)
    text, faults = done.stderr, []
    if done.returncode != code:
        faults.append(f"exit code {done.returncode}, not {code}")
    faults += [f"the error does not say /{s}/" for s in says if not re.search(s, text)]
    if str(out) not in text:
        faults.append("the error does not say where the results are")
    time = re.search(r"error: t = ([\d.e+-]+) s, stage '", text)
    if not time:
        faults.append("the error does not begin with time and stage")
    if text.count("error:") != 1:
        faults.append("not one error")
    if not (out / "summary.json").is_file():
        faults.append("no summary")
    with h5py.File(out / "run.vtkhdf") as file:
        faults += [f"/{n} has numbers that are not finite" for n in not_finite(file)]
        frames = file["VTKHDF/Steps/Values"][...]
        if time and abs(frames[-1] - float(time.group(1))) > 1e-5 * max(frames[-1], 1e-9):
            faults.append(f"the last frame is at {frames[-1]} s, the last good instant at {time.group(1)} s")
        if last is not None and abs(frames[-1] - last) > 1e-9:
            faults.append(f"the last frame is at {frames[-1]} s, not at {last} s")
        found = file["provenance"].attrs.get("status")
        if found != status:
            faults.append(f"status '{found}', not '{status}'")
        reason = file["provenance"].attrs.get("reason", "")
        if not reason or reason not in text:
            faults.append(f"the results give another reason: '{reason}'")
    if faults:
        faults.append("it says: " + text.strip())
    return faults


def main():
    cases = pathlib.Path(__file__).parent / "lost"
    failed = 0
    if {c.stem for c in cases.glob("*.toml")} != set(RUNS):
        print("tests/e2e/lost and this list differ")
        failed = 1
    with tempfile.TemporaryDirectory() as work:
        for name, wanted in RUNS.items():
            try:
                faults = faults_of(sys.argv[1], cases / f"{name}.toml", pathlib.Path(work) / name, wanted)
            except (OSError, KeyError, subprocess.TimeoutExpired) as error:
                faults = [repr(error)]
            for fault in faults:
                print(f"{name}: {fault}")
            failed |= bool(faults)
    print(f"{len(RUNS)} lost runs tried")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
