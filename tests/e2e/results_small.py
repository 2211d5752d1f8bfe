#!/usr/bin/python3
"""A hundred frames of two blocks: the size of the files of a small run; files do not depend on the instants at which
they were flushed.

Usage: results_small.py SCREE SCRATCH
"""
import pathlib
import shutil
import subprocess
import sys

import h5py

import resume_runs

HERE = pathlib.Path(__file__).resolve().parent
MOST = 300e3  # bytes of run.vtkhdf; the numbers themselves are 79 kB
CASE = """
title = "Block on a plane"
material.rock = { density = 2600.0, young = "1 GPa", poisson = 0.2 }
joint.plane = { friction_deg = 20.0 }
support = [{ block = "plane" }]
block = [
  { name = "plane", material = "rock", polygon = [[-4, -12], [20, -12], [-4, 2]] },
  { name = "slider", material = "rock", polygon = [[0, -0.333333333], [1, -0.916666667], [1.6, 0.1], [0.6, 0.7]] },
]
stage = [{ name = "slide", method = "dda", integrator = "implicit", dt = "1 ms", duration = 1.0 }]
"""


def main():
    scree, scratch = sys.argv[1], pathlib.Path(sys.argv[2])
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    case = scratch / "case.toml"
    case.write_text(CASE)
    runs = {}
    # A checkpoint flushes all files: with one at every step, and with none by steps.
    for name, every in (("alone", 0), ("often", 1)):
        runs[name] = scratch / name
        subprocess.run([scree, "run", case, "--out", runs[name], "--quiet", "--set", f"output.checkpoint_steps={every}"], check=True)
        size = (runs[name] / "run.vtkhdf").stat().st_size
        print(f"{name}: run.vtkhdf has {size} bytes")
        if size > MOST:
            resume_runs.fault(f"{name}: run.vtkhdf has {size} bytes, more than {MOST:.0f}")
    for line in resume_runs.differences(runs["often"], runs["alone"]):
        resume_runs.fault(f"brought out at every step: {line}")
    with h5py.File(runs["alone"] / "run.vtkhdf") as file:
        vtk = file["VTKHDF"]
        if vtk["Steps"].attrs["NSteps"] != 101:
            resume_runs.fault(f"{vtk['Steps'].attrs['NSteps']} frames, not 101")
        for name in ("Points", "PointData/displacement", "PointData/velocity", "CellData/stress", "CellData/principal_stress"):
            if vtk[name].dtype != "<f8":
                resume_runs.fault(f"{name} has numbers of the kind {vtk[name].dtype}")
    for check in (["/usr/bin/python3", HERE / "check_results.py", runs["alone"]],
                  ["pvpython", HERE / "check_paraview.py", runs["alone"], "--one-mesh"]):
        done = subprocess.run(list(map(str, check)), capture_output=True, text=True, check=False)
        if done.returncode != 0 or (check[0] == "pvpython" and "paraview: all readers fine" not in done.stdout):
            resume_runs.fault(f"{check[1].name}: {done.stdout[-2000:]}{done.stderr[-2000:]}")
    sys.exit(1 if resume_runs.faults else 0)


if __name__ == "__main__":
    main()
