#!/usr/bin/env python3
"""What a run came to, read by h5py: usage: read_results.py RUN"""
import os
import sys

import h5py
import numpy as np


def file_of(run):
    """A run is its folder, or the file in it."""
    return os.path.join(run, "run.vtkhdf") if os.path.isdir(run) else run


with h5py.File(file_of(sys.argv[1]), "r") as run:
    vtk, steps = run["VTKHDF"], run["VTKHDF/Steps"]
    print(f'{run.attrs["title"]}: {len(run["blocks/name"])} blocks, {steps.attrs["NSteps"]} frames')
    for k, time in enumerate(steps["Values"]):
        first, count = steps["PointOffsets"][k], vtk["NumberOfPoints"][steps["PartOffsets"][k]]
        moved = np.linalg.norm(vtk["PointData/displacement"][first:first + count], axis=1)
        print(f"frame {k:3d}  t = {time:9.4f} s  {count} points, largest displacement {moved.max():.6g} m")
    for name, monitor in run["history"].items():
        print(f'{name}: velocity at the end {monitor["velocity"][-1]} {monitor["velocity"].attrs["units"]}')
    energy = run["energy"]
    print(f'kinetic energy: {energy["kinetic"][:].max():.6g} J at most, {energy["kinetic"][-1]:.6g} J at the end')
    print(f'ledger: closed to {np.abs(energy["closure"][:]).max():.3g} J of {energy["moved"][-1]:.6g} J that moved')
