#!/usr/bin/env python3
"""Resident memory of a long run with output must grow by less than 1 % after step 1,000: the medians of all tenths of the
run are compared with that of steps 500 to 1,500, since buffers of a compression come and go.
Which step a sample belongs to is read from run.xmf, which grows by an entry a frame.
A frame costs about 200 bytes for good (HDF5's list of free space): 10,000 frames are 2 MB.

usage: memory.py SCREE [STEPS]   (default 20000; 100000 if SCREE_FULL is set)
"""
import bisect
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time

scree = sys.argv[1]
steps = int(sys.argv[2]) if len(sys.argv) > 2 else 100000 if os.environ.get("SCREE_FULL") else 20000
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
    samples = []  # bytes of run.xmf, kB in memory
    while process.poll() is None:
        try:
            before = (out / "run.xmf").stat().st_size
            kilobytes = resident(process.pid)
            if kilobytes is not None and (out / "run.xmf").stat().st_size == before:
                samples.append((before, kilobytes))
        except FileNotFoundError:
            pass  # not begun, or ended just now
        time.sleep(0.002)
    if process.wait() != 0:
        sys.exit(f"memory.py: the run failed with {process.returncode}")
    summary = json.loads((out / "summary.json").read_text())
    if summary["steps"] < steps:
        sys.exit(f"memory.py: {summary['steps']} steps, {steps} were asked for")
    # Where the entries of the frames end; the file ends with a few lines more.
    xmf = (out / "run.xmf").read_bytes()
    ends = [m.end() for m in re.finditer(rb"</Grid>", xmf)]
    at = [((bisect.bisect_right(ends, size) - 1) * 100, k) for size, k in samples]
    start = [k for step, k in at if 500 <= step <= 1500]
    tenths = [[k for step, k in at if step > 1500 and n <= 10 * step / steps <= n + 1] for n in range(10)]
    if not start or not tenths[9]:
        sys.exit(f"memory.py: too few samples: {len(start)} at the start, {len(tenths[9])} at the end")
    before = statistics.median(start)
    most = max(statistics.median(t) for t in tenths if t)
    growth = most / before - 1.0
    frames = summary["steps"] // 100 + 1
    size = (out / "run.vtkhdf").stat().st_size
    print(f"{steps} steps, {frames} frames: {before:.0f} kB up to step 1500 ({len(start)} samples), {most:.0f} kB in the tenth with most, "
          f"{100 * growth:.2f} % more; {size / frames:.0f} bytes a frame of {summary['elements']} elements")
    if growth >= 0.01:
        sys.exit("memory.py: resident memory grows by 1 % or more")
