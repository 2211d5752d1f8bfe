"""Opens run.xmf in each XDMF reader of ParaView and compares every frame with what h5py reads of run.vtkhdf.

Usage: pvpython check_paraview.py RUN_FOLDER [--one-mesh]
Prints a line for each thing that does not hold and exits with 1; otherwise "paraview: all readers fine".
"""
import pathlib
import sys

import h5py
import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

POLYGON = 7
READERS = {"XDMFReader": "FileNames", "Xdmf3ReaderS": "FileName", "Xdmf3ReaderT": "FileName"}
POINT_FIELDS = ("displacement", "velocity")
CELL_FIELDS = ("block_id", "element_id", "material_id", "method", "integrator", "displacement", "velocity", "stress",
               "principal_stress")
APART = 1.5e-12  # [s]: frames at one time are told apart by a tick

faults = []


def expect(holds, what):
    if not holds:
        faults.append(what)
    return holds


def stored_frame(file, k):
    """Frame k from /VTKHDF itself; run.xmf must show the same values, although it refers to /xdmf."""
    vtk, steps = file["VTKHDF"], file["VTKHDF/Steps"]
    part = int(steps["PartOffsets"][k])
    points, cells, ids = (int(vtk[n][part]) for n in ("NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"))
    first_cell, first_id = int(steps["CellOffsets"][k]) + part, int(steps["ConnectivityIdOffsets"][k])

    def rows(name, first, count):
        return vtk[name][first:first + count]

    frame = {"points": rows("Points", int(steps["PointOffsets"][k]), points),
             "offsets": rows("Offsets", first_cell, cells + 1), "connectivity": rows("Connectivity", first_id, ids)}
    for kind, names, count in (("PointData", POINT_FIELDS, points), ("CellData", CELL_FIELDS, cells)):
        for name in names:
            frame[kind, name] = rows(f"{kind}/{name}", int(steps[f"{kind}Offsets/{name}"][k]), count)
    return frame


def compare(where, shown, frame):
    """Compares one frame of a reader with the stored one, bit for bit."""
    if not expect(shown.GetClassName() == "vtkUnstructuredGrid", f"{where} is a {shown.GetClassName()}"):
        return
    cells = len(frame["offsets"]) - 1
    if not expect(shown.GetNumberOfPoints() == len(frame["points"]) and shown.GetNumberOfCells() == cells,
                  f"{where}: {shown.GetNumberOfPoints()} points and {shown.GetNumberOfCells()} cells, "
                  f"not {len(frame['points'])} and {cells}"):
        return
    expect(np.array_equal(vtk_to_numpy(shown.GetPoints().GetData()), frame["points"]), f"{where}: other points")
    expect(np.all(vtk_to_numpy(shown.GetCellTypesArray()) == POLYGON), f"{where}: cells that are no polygons")
    polygons = shown.GetCells()
    expect(np.array_equal(vtk_to_numpy(polygons.GetOffsetsArray()), frame["offsets"])
           and np.array_equal(vtk_to_numpy(polygons.GetConnectivityArray()), frame["connectivity"]),
           f"{where}: other cells")
    for kind, names, data in (("PointData", POINT_FIELDS, shown.GetPointData()), ("CellData", CELL_FIELDS, shown.GetCellData())):
        for name in names:
            array = data.GetArray(name)
            if expect(array is not None, f"{where}: no {kind} {name}"):
                expect(np.array_equal(vtk_to_numpy(array), frame[kind, name]), f"{where}: {kind} {name} differs")


def check_reader(name, xmf, times, frames):
    reader = getattr(simple, name)(**{READERS[name]: [str(xmf)]})
    reader.UpdatePipelineInformation()
    steps = np.array(list(reader.TimestepValues))
    if not expect(len(steps) == len(times), f"{name}: {len(steps)} times, not {len(times)}"):
        return
    expect(np.all(np.diff(steps) > 0.0), f"{name}: times do not rise")
    double = np.append(np.diff(times) == 0.0, False)
    expect(np.array_equal(steps[~double], times[~double]), f"{name}: other times")
    expect(np.all((steps[double] < times[double]) & (times[double] - steps[double] < APART)),
           f"{name}: a frame before a hand-over is not just before it")
    for k, time in enumerate(steps):
        reader.UpdatePipeline(time)
        compare(f"{name}, frame {k}", servermanager.Fetch(reader), frames[k])
    # Forward and backward in time: a reader must not keep the mesh of the previous frame.
    for k in (0, len(steps) - 1, 0):
        reader.UpdatePipeline(steps[k])
        compare(f"{name}, frame {k} again", servermanager.Fetch(reader), frames[k])
    # At the time of the hand-over itself the reader must return the new bodies.
    for k in np.flatnonzero(double):
        reader.UpdatePipeline(times[k])
        compare(f"{name}, hand-over", servermanager.Fetch(reader), frames[k + 1])
    simple.Delete(reader)


def main():
    folder = pathlib.Path(sys.argv[1])
    with h5py.File(folder / "run.vtkhdf", "r") as file:
        times = file["VTKHDF/Steps/Values"][...]
        frames = [stored_frame(file, k) for k in range(len(times))]
    sizes = {(len(f["points"]), len(f["offsets"])) for f in frames}
    if "--one-mesh" not in sys.argv[2:]:
        expect(len(sizes) > 1, "the run has no change of topology: nothing is tested")
        expect(np.any(np.diff(times) == 0.0), "the run has no two frames at one time: nothing is tested")
    expect(all(np.any(frames[-1][kind, name] != 0) for kind, name in
               (("PointData", "displacement"), ("CellData", "displacement"), ("CellData", "stress"))),
           "fields of the last frame are zero: nothing is tested")
    for name in READERS:
        check_reader(name, folder / "run.xmf", times, frames)
    for fault in faults:
        print(fault)
    if faults:
        sys.exit(1)
    print(f"{len(times)} frames, sizes {sorted(sizes)}")
    print("paraview: all readers fine")


main()
