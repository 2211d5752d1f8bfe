#!/usr/bin/env python3
"""The cells of any frame with a field of theirs, also where the mesh changes: read_mesh.py RUN [ARRAY]"""
import os
import sys

import h5py


def read_frame(run, k, array):
    vtk, steps = run["VTKHDF"], run["VTKHDF/Steps"]
    mesh = steps["PartOffsets"][k]  # frames on one mesh have the same number
    points, cells, ids = (vtk[n][mesh] for n in ("NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"))
    p, c, i = (steps[n][k] for n in ("PointOffsets", "CellOffsets", "ConnectivityIdOffsets"))
    f = steps["CellDataOffsets/" + array][k]  # where this frame's rows of the field begin
    at = vtk["Offsets"][c + mesh:c + mesh + cells + 1]  # a mesh has one offset more than cells
    corner = vtk["Connectivity"][i:i + ids]
    polygons = [corner[a:b] for a, b in zip(at[:-1], at[1:])]  # rows of the points below
    return vtk["Points"][p:p + points, :2], polygons, vtk["CellData/" + array][f:f + cells]


def file_of(run):
    """A run is its folder, or the file in it."""
    return os.path.join(run, "run.vtkhdf") if os.path.isdir(run) else run


if __name__ == "__main__":
    with h5py.File(file_of(sys.argv[1]), "r") as run:
        array = sys.argv[2] if len(sys.argv) > 2 else "stress"
        for k, time in enumerate(run["VTKHDF/Steps/Values"]):
            points, polygons, field = read_frame(run, k, array)
            print(f"frame {k:3d}  t = {time:9.4f} s  {len(polygons)} cells, {array} from {field.min():.6g} to {field.max():.6g}")
