"""Compares docs/examples/read_mesh.py with the arrays of /xdmf that ParaView reads, every frame: check_mesh.py RUN"""
import pathlib
import sys

import h5py
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs" / "examples"))
from read_mesh import read_frame  # noqa: E402

with h5py.File(pathlib.Path(sys.argv[1]) / "run.vtkhdf", "r") as run:
    steps = run["VTKHDF/Steps"]
    meshes = sorted(set(steps["PartOffsets"][:]))
    assert len(meshes) > 1, "the run has one mesh only"
    total = None
    for k in range(steps.attrs["NSteps"]):
        points, polygons, stress = read_frame(run, k, "stress")
        assert np.array_equal(stress, run[f"xdmf/CellData/stress/{k // 500}/{k}"][:]), f"stress of frame {k}"
        assert np.array_equal(points, run[f"xdmf/Points/{k // 500}/{k}"][:, :2]), f"points of frame {k}"
        assert len(polygons) == len(stress) and max(p.max() for p in polygons) == len(points) - 1, f"cells of frame {k}"
        ring = [points[p] for p in polygons]
        area = sum(0.5 * np.sum(p[:, 0] * np.roll(p[:, 1], -1) - np.roll(p[:, 0], -1) * p[:, 1]) for p in ring)
        total = total or area
        assert abs(area - total) < 1e-2 * total, f"the cells of frame {k} have {area} m2, at first {total} m2"
        _, _, block = read_frame(run, k, "block_id")
        assert set(block) == set(range(len(run["blocks/name"]))), f"blocks of frame {k}"
print(f"{len(meshes)} meshes: read_mesh.py reads every frame")

# The manual shows the same reader.
root = pathlib.Path(__file__).resolve().parents[2]
shown = (root / "docs" / "results.md").read_text().split("```python\n")[1].split("```")[0]
assert shown in (root / "docs" / "examples" / "read_mesh.py").read_text(), "docs/results.md shows another reader"
