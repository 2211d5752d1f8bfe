#!/usr/bin/env python3
"""Compares the final states of viewers (read_live.py --state) with the run's file: same_state.py RUN STATE.json..."""
import json
import sys

import h5py
import numpy as np


def main():
    run = h5py.File(f"{sys.argv[1]}/run.vtkhdf")
    steps = run["VTKHDF/Steps"]
    last = int(steps.attrs["NSteps"]) - 1
    part = int(steps["PartOffsets"][last])
    first, count = int(steps["PointOffsets"][last]), int(run["VTKHDF/NumberOfPoints"][part])
    points = run["VTKHDF/Points"][first:first + count, :2]
    start = run["VTKHDF/Points"][int(steps["PointOffsets"][:][steps["PartOffsets"][:] == part][0]):][:count, :2]
    moved = np.abs(points - start).max()
    failures = 0
    for name in sys.argv[2:]:
        state = json.load(open(name))
        wrong = []

        def check(what, good):
            if not good:
                wrong.append(what)

        check(f"status {state['status']}", state["status"] == "done")
        frame = state["frame"]
        check("time of the frame", frame["time"] == float(steps["Values"][last]))
        check("step of the frame", frame["step"] == int(run["frames/step"][last]))
        error = np.abs(np.column_stack([frame["x"], frame["y"]]) - points).max()
        # Displacements since the start of the mesh are sent in float32, or in 65,534 steps of their range.
        check(f"positions differ by {error:.3g} m of {moved:.3g} m moved", error <= moved * 2.0**-16)
        for column, value in state["energy"].items():
            check(f"energy {column}", value == float(run[f"energy/{column}"][-1]))
        for monitor, values in state["monitors"]["monitors"].items():
            for what, value in values.items():
                check(f"{what} of {monitor}", value == list(run[f"history/{monitor}/{what}"][-1]))
        check(f"{state['malformed']} malformed", state["malformed"] == 0)
        print(f"{name.rsplit('/', 1)[-1]}: {state['frames']} frames, {count} points to {error:.2g} m"
              + "".join(f"\n  WRONG {text}" for text in wrong))
        failures += bool(wrong)
    return 1 if failures else 0


sys.exit(main())
