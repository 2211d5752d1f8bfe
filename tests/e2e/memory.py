#!/usr/bin/env python3
"""Resident memory of a long run with output must grow by less than 1 % once every dataset has its first chunk, which takes half of this
run: until then buffers fill, and each chunked dataset adds HDF5's index of its chunks. Memory held between two writes
to the file is temporary. Of the time after the first frame, the median of the memory from 65 to 82 % is therefore
compared with the median of the rest.
The two are 70,000 steps and 700 frames apart: 1 % is 7 bytes per step or 700 bytes per frame.
A frame keeps 50 to 100 bytes permanently (HDF5's list of free space): 10,000 frames are up to 1 MB.

usage: memory.py SCREE [STEPS]   (default 400000; 2000000 if SCREE_FULL is set)
"""
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

scree = sys.argv[1]
steps = int(sys.argv[2]) if len(sys.argv) > 2 else 2000000 if os.environ.get("SCREE_FULL") else 400000
dt = 1e-4


def case(steps):
    return f"""
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


def run(steps):
    """(samples, summary, bytes of the results): the samples are seconds since the first frame and kB."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "case.toml"
        file.write_text(case(steps))
        out = pathlib.Path(folder) / "run"
        process = subprocess.Popen([scree, "run", str(file), "--out", str(out), "--threads", "1", "--quiet"])
        samples, begin = [], None
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
        return samples, summary, (out / "run.vtkhdf").stat().st_size


samples, summary, size = run(steps)
end = samples[-1][0] if samples else 0.0
settled, later = [k for t, k in samples if 0.65 * end <= t < 0.82 * end], [k for t, k in samples if t >= 0.82 * end]
if len(settled) < 100 or len(later) < 100:
    sys.exit(f"memory.py: the run took {end:.1f} s, too short to tell: give more STEPS")
before, after = statistics.median(settled), statistics.median(later)
growth = after / before - 1.0
frames = summary["steps"] // 100 + 1
print(f"{steps} steps, {frames} frames in {end:.0f} s: {before:.0f} kB from 65 to 82 % of that, {after:.0f} kB after (medians), "
      f"{100 * growth:.2f} % more; {size / frames:.0f} bytes a frame of {summary['elements']} elements")
if growth >= 0.01:
    sys.exit("memory.py: resident memory grows by 1 % or more")
