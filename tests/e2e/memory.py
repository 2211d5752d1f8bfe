#!/usr/bin/env python3
"""Resident memory of a long run with output must grow by less than 1 % once it has brought its results to the file some times, which it
does every second: the most in the second half of the time after 4 s is compared with the most in the first half, since what is held between
two times comes and goes.
Time counts from the first frame: what comes before takes long where the program is not in memory yet.
A frame costs about 200 bytes for good (HDF5's list of free space): 10,000 frames are 2 MB.

usage: memory.py SCREE [STEPS]   (default 400000; 2000000 if SCREE_FULL is set)
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

scree = sys.argv[1]
steps = int(sys.argv[2]) if len(sys.argv) > 2 else 2000000 if os.environ.get("SCREE_FULL") else 400000
dt = 1e-4
CASE = f"""
title = "A block that slides and settles, watched for long"
material.rock = {{ density = 2500.0, young = "1 GPa", poisson = 0.2 }}
joint.plane = {{ friction_deg = 31.0 }}
support = [{{ block = "slope" }}]
monitor = [{{ name = "top", block = "slider", point = [1.2, 5.2] }}]
block = [
  {{ name = "slope", material = "rock", polygon = [[0, 0], [8.660254037844387, 0], [0, 5]] }},
  {{ name = "slider", material = "rock", polygon = [[0.4330127018922194, 4.75], [1.299038105676658, 4.25], [1.799038105676658, 5.116025403784438], [0.9330127018922193, 5.616025403784438]] }},
]
stage = [{{ name = "rest", method = "nmm", integrator = "explicit", cover_size = 0.3, dt = {dt}, force_dt = true, damping = 50.0, duration = {steps * dt} }}]
[output]
every = {100 * dt}
history_every = {10 * dt}
contacts = true
"""


def resident(pid):
    for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmRSS"):
            return int(line.split()[1])  # kB
    return None  # it has ended


with tempfile.TemporaryDirectory() as folder:
    case = pathlib.Path(folder) / "case.toml"
    case.write_text(CASE)
    out = pathlib.Path(folder) / "run"
    process = subprocess.Popen([scree, "run", str(case), "--out", str(out), "--threads", "1", "--quiet"])
    samples = []  # since the first frame: seconds, kB
    begin = None
    while process.poll() is None:
        try:
            if begin is None and (out / "run.xmf").exists():
                begin = time.monotonic()
            if begin is not None and (kilobytes := resident(process.pid)) is not None:
                samples.append((time.monotonic() - begin, kilobytes))
        except FileNotFoundError:
            break  # it has ended
        time.sleep(0.002)
    if process.wait() != 0:
        sys.exit(f"memory.py: the run failed with {process.returncode}")
    summary = json.loads((out / "summary.json").read_text())
    if summary["steps"] < steps:
        sys.exit(f"memory.py: {summary['steps']} steps, {steps} were asked for")
    end = samples[-1][0]
    middle = 4.0 + 0.5 * (end - 4.0)
    first, second = [k for t, k in samples if 4.0 <= t < middle], [k for t, k in samples if t >= middle]
    if end < 7.0 or not first or not second:
        sys.exit(f"memory.py: the run took {end:.1f} s, too short to tell: give more STEPS")
    before, most = max(first), max(second)
    growth = most / before - 1.0
    frames = summary["steps"] // 100 + 1
    size = (out / "run.vtkhdf").stat().st_size
    print(f"{steps} steps, {frames} frames: {before:.0f} kB at most from 4 to {middle:.0f} s, {most:.0f} kB at most after that, "
          f"{100 * growth:.2f} % more; {size / frames:.0f} bytes a frame of {summary['elements']} elements")
    if growth >= 0.01:
        sys.exit("memory.py: resident memory grows by 1 % or more")
