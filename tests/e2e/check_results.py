#!/usr/bin/python3
"""Checks a run folder as another program sees it: layout of run.vtkhdf, units, times, ledger, tables, summary.

Usage: check_results.py RUN_FOLDER [--unfinished] [--contacts]
Exit code 0 when everything holds; otherwise 1, with a line for each thing that does not.
"""
import argparse
import csv
import hashlib
import json
import pathlib
import sys
import xml.etree.ElementTree

import h5py
import numpy as np

POLYGON = 7
TEXT_BYTES = 16  # of a variable-length text in its dataset: length and place in the heap
CELL_FIELDS = {"block_id": 1, "element_id": 1, "material_id": 1, "method": 1, "integrator": 1, "stress": 3,
               "displacement": 3, "velocity": 3, "principal_stress": 2}
POINT_FIELDS = {"displacement": 3, "velocity": 3}
GROUPS = ("history", "energy", "events", "transfers", "blocks", "frames", "provenance", "materials", "stages", "methods", "xdmf")
SIGN = {"energy": 1.0, "dissipated": 1.0, "work": -1.0, "scheme": -1.0}  # closure = E - E_0 - W + D - R

faults = []


def expect(holds, what):
    if not holds:
        faults.append(what)


def attempt(check, *arguments):
    """Missing data that a check requires is a fault, too; the other checks continue."""
    try:
        check(*arguments)
    except (KeyError, IndexError, ValueError, OSError) as error:
        faults.append(f"{check.__name__} stopped: {error!r}")


def texts(dataset):
    return [t.decode() for t in dataset[...]]


def check_labels(file):
    """Every dataset has units and a name, without exception, also those that VTKHDF prescribes.

    All but windows (virtual datasets, which hold nothing) have chunks of at most 128 KiB, small ones of what the case
    lets expect, but no smaller than 128 bytes, shuffle and deflate.
    """
    seen = []

    def visit(name, item):
        if not isinstance(item, h5py.Dataset):
            return
        for key in ("units", "long_name"):
            expect(isinstance(item.attrs.get(key), str) and item.attrs[key], f"/{name} has no {key}")
        seen.append(name)
        if item.is_virtual:
            expect(name.startswith("xdmf/"), f"/{name} is virtual")
            return
        text = h5py.check_string_dtype(item.dtype) is not None
        size = int(np.prod(item.chunks)) * (TEXT_BYTES if text else item.dtype.itemsize)
        held = len(item) * int(np.prod(item.shape[1:])) * item.dtype.itemsize
        expect(128 <= size <= 128 * 1024, f"/{name} has chunks of {size} bytes")
        expect(held < 64 * size or size >= 64 * 1024, f"/{name} has chunks of {size} bytes for {held}")
        expect(item.shuffle and item.compression == "gzip", f"/{name} is not shuffled and deflated")
    file.visititems(visit)
    expect(len(seen) > 60, f"only {len(seen)} datasets seen")


def check_windows(file):
    """Each virtual dataset of /xdmf shows rows of the dataset with the same name in /VTKHDF of this file, with the same
    units."""
    for kind in ("Points", "PointData", "CellData"):
        fields = []
        if kind in file["xdmf"]:
            file["xdmf"][kind].visititems(lambda name, item: fields.append((name, item)) if isinstance(item, h5py.Dataset) else None)
        for name, window in fields:
            source = file["VTKHDF"][f"{kind}/{name}".rsplit("/", 2)[0]]
            mapped = window.virtual_sources()
            expect(len(mapped) == 1 and mapped[0].file_name == "." and mapped[0].dset_name == source.name,
                   f"{window.name} does not show {source.name}")
            expect(dict(window.attrs) == dict(source.attrs), f"{window.name} has other units or another name than {source.name}")
            (first, *_), (last, *_) = mapped[0].src_space.get_select_bounds()
            expect(np.array_equal(window[...], source[first:last + 1]), f"{window.name} shows other values than {source.name}")


def check_arrays(folder, file):
    """Every frame of run.xmf has every array: an existing dataset of /xdmf, or at most 100 numbers that equal those of
    /VTKHDF."""
    vtk, steps = file["VTKHDF"], file["VTKHDF/Steps"]
    frames = xml.etree.ElementTree.parse(folder / "run.xmf").getroot().findall("./Domain/Grid/Grid")
    expect(len(frames) == len(steps["Values"]), f"run.xmf has {len(frames)} frames, not {len(steps['Values'])}")
    for k, frame in enumerate(frames):
        mesh = int(steps["PartOffsets"][k])
        count = {"Node": int(vtk["NumberOfPoints"][mesh]), "Cell": int(vtk["NumberOfCells"][mesh])}
        arrays = {("Node", None): (frame.find("Geometry/DataItem"), "Points", "PointOffsets")}
        for attribute in frame.findall("Attribute"):
            kind = {"Node": "PointData", "Cell": "CellData"}[attribute.get("Center")]
            arrays[attribute.get("Center"), attribute.get("Name")] = (
                attribute.find("DataItem"), f"{kind}/{attribute.get('Name')}", f"{kind}Offsets/{attribute.get('Name')}")
        expect(set(arrays) == {("Node", None)} | {("Node", n) for n in POINT_FIELDS} | {("Cell", n) for n in CELL_FIELDS},
               f"frame {k} of run.xmf has other arrays")
        for (center, _), (item, name, offsets) in arrays.items():
            first = int(steps[offsets][k])
            stored = vtk[name][first:first + count[center]]
            shape = tuple(int(n) for n in item.get("Dimensions").split())
            expect(shape == stored.shape, f"frame {k}: {name} has the shape {shape} in run.xmf, not {stored.shape}")
            if item.get("Format") == "XML":
                expect(stored.size <= 100, f"frame {k}: {name} stands in run.xmf with {stored.size} numbers")
                expect(np.array_equal(np.array(item.text.split(), dtype=float).reshape(shape), stored), f"frame {k}: {name} differs in run.xmf")
            else:
                path = item.text.strip().partition(":")[2]
                expect(path in file and file[path].shape == shape, f"frame {k}: {name} has no window {path}")


def check_frames(file):
    """Offsets of every frame point to existing, consistent rows (VTKHDF 2.0)."""
    vtk, steps = file["VTKHDF"], file["VTKHDF/Steps"]
    expect(vtk.attrs["Type"] == b"UnstructuredGrid", "Type is not UnstructuredGrid")
    expect(list(vtk.attrs["Version"]) == [2, 0], "Version is not 2, 0")
    n = int(steps.attrs["NSteps"])
    for name in ("Values", "PartOffsets", "NumberOfParts", "PointOffsets", "CellOffsets", "ConnectivityIdOffsets"):
        expect(len(steps[name]) == n, f"Steps/{name} has {len(steps[name])} rows, not {n}")
    for name, item in file["frames"].items():
        expect(len(item) == n, f"/frames/{name} has {len(item)} rows, not {n}")
    times = steps["Values"][...]
    expect(np.all(np.diff(times) >= 0.0), "times of the frames go back")
    expect(np.allclose(times, file["frames/tick"][...] * 1e-12, rtol=1e-15, atol=1e-15), "times are not those of the ticks")

    meshes = len(vtk["NumberOfCells"])
    expect(len(vtk["Offsets"]) == int(vtk["NumberOfCells"][...].sum()) + meshes, "Offsets has not cells + 1 a mesh")
    expect(len(vtk["Connectivity"]) == int(vtk["NumberOfConnectivityIds"][...].sum()), "Connectivity is not stored once a mesh")
    expect(np.all(vtk["Types"][...] == POLYGON), "cells are not all polygons")
    used = steps["PartOffsets"][...]
    expect(np.array_equal(np.unique(used), np.arange(meshes)), "a mesh is stored that no frame uses")
    blocks, methods = len(file["blocks/name"]), len(file["methods/name"])

    for k in range(n):
        part = int(used[k])
        points, cells, ids = (int(vtk[x][part]) for x in ("NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"))
        first_cell = int(steps["CellOffsets"][k])
        offsets = vtk["Offsets"][first_cell + part:first_cell + part + cells + 1]
        first_id = int(steps["ConnectivityIdOffsets"][k])
        connectivity = vtk["Connectivity"][first_id:first_id + ids]
        expect(offsets[0] == 0 and offsets[-1] == ids == len(connectivity), f"frame {k}: Offsets and Connectivity do not fit")
        expect(np.all(np.diff(offsets) >= 3), f"frame {k}: a cell has fewer than three points")
        expect(connectivity.min() >= 0 and connectivity.max() < points, f"frame {k}: Connectivity leaves the points")
        fields = {}
        for name, width in CELL_FIELDS.items():
            at = int(steps["CellDataOffsets"][name][k])
            fields[name] = vtk["CellData"][name][at:at + cells]
            expect(fields[name].shape == ((cells,) if width == 1 else (cells, width)), f"frame {k}: {name} has another shape")
        for name, width in POINT_FIELDS.items():
            at = int(steps["PointDataOffsets"][name][k])
            fields[name] = vtk["PointData"][name][at:at + points]
            expect(fields[name].shape == (points, width), f"frame {k}: {name} has another shape")
        at = int(steps["PointOffsets"][k])
        position = vtk["Points"][at:at + points]
        expect(position.shape == (points, 3) and np.all(position[:, 2] == 0.0), f"frame {k}: points are not in the plane")
        expect(fields["block_id"].min() >= 0 and fields["block_id"].max() < blocks, f"frame {k}: a block is not in /blocks")
        expect(fields["method"].min() >= 0 and fields["method"].max() < methods, f"frame {k}: a method is not in /methods")
        scheme = int(file["frames/integrator"][k])  # 2: each block has its own integrator, the same for all its cells
        schemes = fields["integrator"]
        if scheme == 2:
            pairs = set(zip(fields["block_id"].tolist(), schemes.tolist()))
            expect(set(schemes.tolist()) <= {0, 1} and len(pairs) == len(set(fields["block_id"].tolist())),
                   f"frame {k}: integrator is not one a block, 0 or 1")
        else:
            expect(np.all(schemes == scheme), f"frame {k}: integrator differs from /frames")
        s, p = fields["stress"], fields["principal_stress"]
        scale = max(1.0, float(np.abs(s).max()))
        expect(np.all(p[:, 0] >= p[:, 1]), f"frame {k}: the larger principal stress is not first")
        expect(np.allclose(p.sum(axis=1), s[:, 0] + s[:, 1], atol=1e-12 * scale), f"frame {k}: principal stresses lose the trace")
        determinant = s[:, 0] * s[:, 1] - s[:, 2] ** 2
        expect(np.allclose(p.prod(axis=1), determinant, atol=1e-12 * scale ** 2), f"frame {k}: principal stresses lose the determinant")


def check_ledger(file):
    """The columns, each with the sign of its side, add up to the closure that the run itself computed."""
    energy = file["energy"]
    columns = {name: item for name, item in energy.items() if "side" in item.attrs}
    expect(len(columns) > 0, "no ledger columns")
    rows = len(energy["time"])
    for name, item in energy.items():
        expect(len(item) == rows, f"/energy/{name} has {len(item)} rows, not {rows}")
        expect(name == "time" or item.attrs.get("units") == "J", f"/energy/{name} is not in J")
    expect(np.all(np.diff(energy["time"][...]) >= 0.0), "times of the ledger go back")
    held = sum(c[...] for c in columns.values() if c.attrs["side"] == "energy")
    moved = energy["moved"][...]
    rounding = 1e-13 * (moved + np.abs(held) + 1.0)  # round-off of sums of some twenty terms
    expect(np.all(np.abs(held - energy["energy"][...]) <= rounding), "energy is not the sum of its columns")
    total = sum(SIGN[c.attrs["side"]] * c[...] for c in columns.values())
    change = total - energy["closure"][...]  # E_0, a constant
    expect(np.all(np.abs(change - change[0]) <= rounding), "ledger columns do not add up to the closure")
    expect(np.all(np.diff(moved) >= 0.0), "moved decreases")


def check_histories(file, last):
    for name, monitor in file["history"].items():
        time = monitor["time"][...]
        expect(np.all(np.diff(time) >= 0.0), f"times of monitor {name} go back")
        expect(len(time) > 0 and abs(time[-1] - last) <= 1e-9 * max(1.0, last), f"monitor {name} does not reach the last frame")
        for field, width in (("position", 2), ("displacement", 2), ("velocity", 2), ("stress", 3)):
            expect(monitor[field].shape == (len(time), width), f"monitor {name}: {field} has another shape")
        shift = monitor["position"][...] - monitor["displacement"][...]
        shift = shift[np.isfinite(shift[:, 0])]  # its block may exist during a part of the run only
        expect(len(shift) == 0 or np.allclose(shift, shift[0], atol=1e-9), f"monitor {name}: position less displacement varies")


CONTACT_WIDTHS = {"corner": 4, "edge": 3, "joint": 1, "state": 1, "facing": 1, "bonded": 1, "failed": 1, "position": 2, "normal": 2,
                  "share": 1, "gap": 1, "gap0": 1, "fn": 1, "ft": 1, "water": 1, "slip": 1}


def check_contacts(file):
    """The rows of /contacts are sorted by frame, and their values satisfy the contact law."""
    group, frames = file["contacts"], len(file["VTKHDF/Steps/Values"])
    first, count = group["frames/first"][...], group["frames/count"][...]
    expect(len(first) == len(count) == frames, "/contacts/frames has not a row a frame")
    expect(np.array_equal(first, np.concatenate(([0], np.cumsum(count)[:-1]))), "frames of /contacts do not follow one another")
    rows = int(count.sum())
    for name, width in CONTACT_WIDTHS.items():
        expect(group[name].shape == ((rows,) if width == 1 else (rows, width)), f"/contacts/{name} has another shape")
    c = {name: group[name][...] for name in CONTACT_WIDTHS}
    expect(rows > 0 and np.any(c["state"] > 0), "nothing touches in the whole run")
    blocks, joints = len(file["blocks/name"]), len(file["joints/name"])
    for side in ("corner", "edge"):
        expect(c[side].min() >= 0 and c[side][:, 0].max() < blocks, f"/contacts/{side} names a block that is not in /blocks")
    faces = (c["corner"][:, 1] == c["edge"][:, 1]) & (c["corner"][:, 1] > 0)  # of a crack
    expect(np.all((c["corner"][:, 0] != c["edge"][:, 0]) | faces), "a block touches itself")
    expect(c["joint"].min() >= 0 and c["joint"].max() < joints, "a law is not in /joints")
    expect(np.allclose(np.linalg.norm(c["normal"], axis=1), 1.0, atol=1e-14), "normals are not unit vectors")
    is_open, loose = c["state"] == 0, c["bonded"] == 0
    expect(np.all((c["state"] >= 0) & (c["state"] <= 2)), "a state is none of 0, 1, 2")
    expect(np.all(c["fn"][is_open] == 0.0) and np.all(c["ft"][is_open] == 0.0), "an open contact has a force")
    expect(np.all(c["fn"][loose] >= 0.0), "a contact without a bond pulls")
    expect(np.all(c["share"] > 0.0) and np.all(c["slip"] >= 0.0), "a share or slip is negative")
    for k in range(frames):  # each contact once, in order
        keys = [tuple(key) for key in np.hstack([c["corner"], c["edge"]])[first[k]:first[k] + count[k]]]
        expect(keys == sorted(set(keys)), f"frame {k}: contacts are not sorted, or twice there")


def check_tables(folder, file):
    """CSV and HDF5 hold the same numbers, bit for bit."""
    def table(name):
        with open(folder / name, newline="", encoding="utf-8") as f:
            rows = list(csv.reader(f))
        expect(all(c.endswith("]") and " [" in c for c in rows[0]), f"{name}: a column has no unit")
        return [c.rsplit(" [", 1)[0] for c in rows[0]], np.array(rows[1:], dtype=float)
    names, numbers = table("energy.csv")
    for i, name in enumerate(names):
        if name in file["energy"]:
            expect(np.array_equal(numbers[:, i], file["energy"][name][...]), f"energy.csv: {name} differs from /energy")
    names, numbers = table("history.csv")
    for i, name in enumerate(names):
        monitor, _, what = name.rpartition(".")
        field = {"x": ("position", 0), "y": ("position", 1), "ux": ("displacement", 0), "uy": ("displacement", 1),
                 "vx": ("velocity", 0), "vy": ("velocity", 1),
                 "sxx": ("stress", 0), "syy": ("stress", 1), "sxy": ("stress", 2)}.get(what)
        if field and monitor in file["history"]:
            expect(np.array_equal(numbers[:, i], file["history"][monitor][field[0]][:, field[1]], equal_nan=True), f"history.csv: {name} differs from /history")


def check_summary(folder, file, last):
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    expect(summary["status"] in ("done", "interrupted", "not_converged", "non_finite"), "unknown status")
    expect(summary["final_time"] == last, "final_time is not the time of the last frame")
    expect(int(summary["state_hash"], 16) == int(file["frames/state_hash"][-1]), "state_hash is not that of the last frame")
    expect(summary["case_sha256"] == file["provenance"].attrs["case_sha256"], "case_sha256 differs from /provenance")
    expect([b["name"] for b in summary["blocks"]] == texts(file["blocks/name"]), "blocks differ from /blocks")
    expect(len(summary["transfers"]) == len(file["transfers/time"]), "transfers differ from /transfers")
    for side, columns in summary["ledger"]["columns"].items():
        for name in columns:
            expect(file["energy"][name].attrs["side"] == side, f"ledger column {name} is on another side in /energy")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("run", type=pathlib.Path)
    parser.add_argument("--unfinished", action="store_true", help="a run that was killed: no summary, histories to the last frame")
    parser.add_argument("--contacts", action="store_true", help="the run wrote its contacts")
    arguments = parser.parse_args()
    with h5py.File(arguments.run / "run.vtkhdf", "r") as file:
        for group in GROUPS:
            expect(group in file, f"group /{group} is missing")
        times = file["VTKHDF/Steps/Values"][...]
        attempt(check_labels, file)
        attempt(check_windows, file)
        attempt(check_frames, file)
        attempt(check_ledger, file)
        attempt(check_histories, file, times[-1])
        expect(("contacts" in file) == arguments.contacts, "/contacts is there, or not, against what was asked for")
        if "contacts" in file:
            attempt(check_contacts, file)
        case = file["provenance/case"][0]
        expect(hashlib.sha256(case).hexdigest() == file["provenance"].attrs["case_sha256"], "SHA-256 is not that of the case text")
        if not arguments.unfinished:
            attempt(check_arrays, arguments.run, file)
            attempt(check_tables, arguments.run, file)
            attempt(check_summary, arguments.run, file, times[-1])
    for fault in faults:
        print(f"{arguments.run}: {fault}")
    if not faults:
        print(f"{arguments.run}: {len(times)} frames, fine")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
