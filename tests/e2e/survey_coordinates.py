#!/usr/bin/python3
"""A slope near (0, 0), and the same one in survey coordinates: the same physics, and results that state their origin.

Usage: survey_coordinates.py SCREE
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy as np

FAR = (512340.7, 4123456.3)
DENSITY, GRAVITY = 2600.0, 9.81
SAME = 1e-6  # of the largest displacement; of the weight of 1 m2


def case(x, y):
    def points(*list_of_points):
        return "[" + ", ".join(f"[{x + a!r}, {y + b!r}]" for a, b in list_of_points) + "]"

    def point(a, b):
        return points((a, b))[1:-1]

    return f"""title = "Slope with a wedge"
[model]
default_joint = "rough"
cover_size = 1.5
[material.rock]
density = {DENSITY}
young = "1 GPa"
poisson = 0.2
[material.rock.initial_stress]
xx = 0
yy = 0
gradient_xx = -8e3
gradient_yy = -25506
level = {y + 6.0!r}
[joint.rough]
friction_deg = 35
[joint.clay]
friction_deg = 12
[domain]
outline = {points((0, -2), (14, -2), (14, 0), (8, 0), (5, 6), (0, 6))}
material = "rock"
snap = 1e-4                 # FAR lies on this grid
[[domain.region]]
name = "base"
polygon = {points((0, -2), (14, -2), (14, 0), (8, 0), (0, 0))}
cut = false
[[domain.trace]]
points = {points((0, 5), (8, 0.3))}
joint = "clay"
[[domain.joint_set]]
joint = "rough"
dip_deg = 75
spacing = 1.6
spacing_deviation = 0.2
origin = {point(2, 0)}
[[support]]
blocks = ["base-*"]
[[support]]
block = "block-1"
point = {point(0, 0)}
stiffness = "1 MN/m"
[[water]]
line = {points((-100, 1.5), (6, 0.5), (40, 0.5))}
joints = ["clay"]
[[point_load]]
point = {point(0, 6)}
force = ["20 kN", 0]
[[traction]]
block = "block-10"
on = {points((0, 6), (5, 6))}
pressure = "1 kPa"
[[monitor]]
name = "crest"
point = {point(4.9, 6)}
[[stage]]
name = "slip"
method = "nmm"
integrator = "explicit"
dt = "20 us"                # dt = "auto" weighs which of two corners at one place was listed first: that is up to round-off
duration = 0.02
[[stage]]
name = "slide"
method = "dda"
integrator = "implicit"
dt = "1 ms"
duration = 0.1
[output]
every = 0.02
history_every = 0.005
contacts = true
"""


# A block that a load inverts: the message states the place.
BROKEN = """[model]
gravity = [0, 0]
[material.soft]
density = 2000.0
young = "1 MPa"
poisson = 0.3
[[block]]
name = "victim"
polygon = [[512340, 4123456], [512342, 4123456], [512342, 4123457], [512340, 4123457]]
material = "soft"
[[point_load]]
point = [512341, 4123457]
force = [0, "-20 MN"]
[[stage]]
name = "blow"
method = "nmm"
integrator = "explicit"
cover_size = 0.4
duration = "100 ms"
"""

faults = []


def expect(holds, what):
    if not holds:
        faults.append(what)


def scree(*arguments):
    return subprocess.run([sys.argv[1], *map(str, arguments)], capture_output=True, text=True, timeout=200)


def run(folder, name, text):
    file = folder / f"{name}.toml"
    file.write_text(text, encoding="utf-8")
    done = scree("run", file, "--out", folder / name, "--quiet")
    if done.returncode != 0:
        sys.exit(f"{name}: exit code {done.returncode}: {done.stderr}")
    return h5py.File(folder / name / "run.vtkhdf")


def compare(what, near, far, scale):
    if near.shape != far.shape:
        faults.append(f"{what}: {near.shape} near, {far.shape} far")
        return
    error = np.abs(near - far).max() / scale
    print(f"{what}: {error:.1e}")
    expect(error <= SAME, f"{what} differs by {error:.2g} of {scale:.3g}")


def contact_forces(file):
    """x, y of the force of contacts and their water on each block, per frame [N]."""
    contacts = file["contacts"]
    block_p, block_e = contacts["corner"][:, 0], contacts["edge"][:, 0]
    normal = contacts["normal"][...]
    along = np.stack((-normal[:, 1], normal[:, 0]), axis=1)
    force = (contacts["fn"][...] + contacts["water"][...])[:, None] * normal + contacts["ft"][...][:, None] * along
    first, count = contacts["frames/first"][...], contacts["frames/count"][...]
    sums = np.zeros((len(first), len(file["blocks/name"]), 2))
    for k in range(len(first)):
        rows = slice(first[k], first[k] + count[k])
        np.add.at(sums[k], block_p[rows], force[rows])
        np.add.at(sums[k], block_e[rows], -force[rows])
    return sums


def main():
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(work)
        near, far = run(folder, "near", case(0, 0)), run(folder, "far", case(*FAR))
        origin = far.attrs["origin"]
        expect(np.abs(origin - FAR).max() < 40, f"origin {origin} is not near {FAR}")
        expect(np.array_equal(near.attrs["origin"], (0, 0)), "the slope near (0, 0) has an origin")
        summary = json.loads((folder / "far/summary.json").read_text(encoding="utf-8"))
        expect(summary["origin"] == list(origin), "summary.json has another origin")
        told = f"coordinates are counted from ({origin[0]:.0f}, {origin[1]:.0f}) m"
        expect(told in (folder / "far/run.log").read_text(encoding="utf-8").splitlines()[0], "run.log does not begin with the origin")
        expect("counted from" not in (folder / "near/run.log").read_text(encoding="utf-8"), "the near run.log has an origin")
        expect(told in scree("check", folder / "far.toml").stdout, "scree check does not tell the origin")

        shift = np.array(FAR) - origin
        for path in ("blocks/point", "joints/lines/from", "joints/lines/to", "history/crest/position"):
            error = np.abs(far[path][...] - shift - near[path][...]).max()
            expect(error < 1e-8, f"{path} is {error:.2g} m from where it should be")
        moved = np.abs(near["VTKHDF/PointData/displacement"][...]).max()
        expect(moved > 1e-3, "nothing moves")
        for path in ("VTKHDF/PointData/displacement", "history/crest/displacement"):
            compare(path, near[path][...], far[path][...], moved)
        forces = contact_forces(near)
        expect(np.abs(forces).max() > DENSITY * GRAVITY, "nothing touches")
        compare("forces of contacts", forces, contact_forces(far), DENSITY * GRAVITY)

        file = folder / "broken.toml"
        file.write_text(BROKEN, encoding="utf-8")
        says = scree("run", file, "--out", folder / "broken", "--quiet").stderr
        expect("near (51234" in says and ", 412345" in says, "a message does not name the place in the coordinates of the case: " + says)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
