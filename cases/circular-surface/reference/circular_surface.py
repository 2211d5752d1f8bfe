"""The arc of the case circular-surface: its calibration on a single block, and its case.toml.

usage: circular_surface.py             prints the friction that one block needs, by how its pressure is spread; checks itself
       circular_surface.py --write     writes ../case.toml
       circular_surface.py --required  bisects the friction of the surface that one block and the slices need, by runs of scree

A rigid block on a circular surface can only turn about the centre. A tangent of dip t touches the arc at C + R(sin t, -cos t). In the
limit friction acts uphill with m N at every point; the pressure N is that of springs under the block after a small
displacement of the block, N = A sin t + B cos t. Forces and the moment about the centre,
  int N (m cos t - sin t) R dt = 0,   int N (cos t + m sin t) R dt = W,   m R int N R dt = W (x_g - C_x),
give A, B and m. If the block bears on its two ends instead, N is concentrated there and m is smaller.
"""
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
HEIGHT, FACE = 100.0, 50.0                  # 2:1, vertical to horizontal [m]
BELOW = 40.0                                # of the face that stays [m]
HALF = 20.0                                 # half of the angle of the arc [deg]
CHORDS = 80                                 # half a degree each
SLICES = 24
WANTED = 38.0                               # one block, source [deg]
DENSITY, GRAVITY = 2500.0, 9.81


def arc(run):
    """Centre, radius and dip of the chord, of the arc from the toe (0, 0) to (run, HEIGHT)."""
    half = math.radians(HALF)
    dip = math.atan2(HEIGHT, run)
    radius = 0.5 * math.hypot(run, HEIGHT) / math.sin(half)
    t = dip - half                          # dip of the tangent at the toe
    return (-radius * math.sin(t), radius * math.cos(t)), radius, dip


def surface(run, chords=CHORDS):
    """Corners of the arc from the toe up."""
    (x, y), radius, dip = arc(run)
    points = []
    for i in range(chords + 1):
        t = dip + math.radians(HALF) * (2.0 * i / chords - 1.0)
        points.append((x + radius * math.sin(t), y - radius * math.cos(t)))
    points[0], points[-1] = (0.0, 0.0), (run, HEIGHT)
    return points


def centroid(corners):
    size = x = 0.0
    for (x0, y0), (x1, y1) in zip(corners, corners[1:] + corners[:1]):
        cross = x0 * y1 - x1 * y0
        size += 0.5 * cross
        x += (x0 + x1) * cross / 6.0
    return abs(size), x / size


def lever(run):
    """Horizontal distance of the weight from the centre over the radius, by a polygon fine enough to stand for the
    arc."""
    (x, _), radius, _ = arc(run)
    return (centroid(surface(run, 20000) + [(FACE, HEIGHT)])[1] - x) / radius


def integrals(t0, t1):
    """int of sin^2, sin cos, cos^2, sin, cos."""
    ss = 0.5 * (t1 - t0) - 0.25 * (math.sin(2 * t1) - math.sin(2 * t0))
    return ss, 0.5 * (math.sin(t1) ** 2 - math.sin(t0) ** 2), (t1 - t0) - ss, math.cos(t0) - math.cos(t1), math.sin(t1) - math.sin(t0)


def limit(run, ends=False):
    """Friction angle [deg] in the limit; ends: the block bears on its two ends."""
    _, _, dip = arc(run)
    t0, t1 = dip - math.radians(HALF), dip + math.radians(HALF)
    d = lever(run)
    low, high = 1e-3, 3.0
    for _ in range(100):                    # the moment required by the weight, minus that of friction, decreases with m
        m = 0.5 * (low + high)
        if ends:
            n = [[m * math.cos(t) - math.sin(t) for t in (t0, t1)], [math.cos(t) + m * math.sin(t) for t in (t0, t1)]]
            moments = (1.0, 1.0)
        else:
            ss, sc, cc, s, c = integrals(t0, t1)
            n = [[m * sc - ss, m * cc - sc], [sc + m * ss, cc + m * sc]]
            moments = (s, c)
        det = n[0][0] * n[1][1] - n[0][1] * n[1][0]
        a, b = -n[0][1] / det, n[0][0] / det          # of W = 1
        if m * (a * moments[0] + b * moments[1]) < d:
            low = m
        else:
            high = m
    if ends:
        assert a > 0.0 and b > 0.0
    else:
        assert all(a * math.sin(t) + b * math.cos(t) > 0.0 for t in (t0, t1))
    return math.degrees(math.atan(m))


def calibrated():
    """Run of the arc for which one block needs WANTED [m], to the centimetre."""
    low, high = 60.0, 400.0
    for _ in range(60):
        run = 0.5 * (low + high)
        low, high = (run, high) if limit(run) > WANTED else (low, run)
    return round(low, 2)


def check():
    # For a nearly straight arc both pressure distributions give the dip of the plane.
    global HALF
    kept, HALF = HALF, 0.01
    for run in (100.0, 140.0):
        assert abs(limit(run) - math.degrees(math.atan2(HEIGHT, run))) < 0.02 and abs(limit(run, True) - limit(run)) < 1e-4
    HALF = kept


def points(line):
    return "[" + ", ".join(f"[{x:.6f}, {y:.6f}]" for x, y in line) + "]"


def cuts(run):
    """Verticals through corners of the arc, at nearly equal spacing."""
    corners = surface(run)
    out = []
    for i in range(1, SLICES):
        x = min((c[0] for c in corners), key=lambda c: abs(c - run * i / SLICES))
        out.append([(x, -20.0), (x, HEIGHT + 60.0)])
    return out


def traces(lines):
    return "[" + ", ".join(f'{{ joint = "slices", points = {points(line)} }}' for line in lines) + "]"


def case_text(run):
    corners = surface(run)
    left, right, bottom = -80.0, run + 40.0, -60.0
    below = [(-0.5 * BELOW, -BELOW), (left, -BELOW)]    # the face continues below the toe, so that nothing supports the slide there
    base = [(left, bottom), (right, bottom), (right, HEIGHT), *reversed(corners), *below]
    outline = [(left, bottom), (right, bottom), (right, HEIGHT), (FACE, HEIGHT), *below]
    sliced = "\n".join(f'[[domain.trace]]\njoint = "slices"\npoints = {points(line)}\n' for line in cuts(run))
    head = cuts(run)[SLICES // 2][0][0] + 2.0
    return f"""# A slope of 2:1 (vertical to horizontal) on a circular surface of {CHORDS} chords, cut into {SLICES} vertical slices.
# Written by reference/circular_surface.py; expected.toml has the single block on the same surface.
title = "Circular surface: one block or {SLICES} slices"

[model]
default_joint = "slices"

[material.rock]
density = {DENSITY}
young = "5 GPa"
poisson = 0.2

[joint.slip]             # the surface
friction_deg = 40.0

[joint.slices]           # between slices
friction_deg = 5.0

[domain]
outline = {points(outline)}
material = "rock"
prefix = "slice"

[[domain.region]]
name = "base"
polygon = {points(base)}
joint = "slip"
cut = false

{sliced}
[[support]]
block = "base-1"

[[monitor]]
name = "toe"
point = [4.0, 3.0]

[[monitor]]
name = "head"            # of a slice in the middle
point = [{head:.6f}, {HEIGHT - 3.0}]

[[monitor]]
name = "foot"            # of the same slice
point = [{head:.6f}, {foot(run, head):.6f}]

[[monitor]]
name = "scarp"           # at the back
point = [{run - 2.0:.6f}, {HEIGHT - 1.0}]

[[stage]]                # springs take up the weight
name = "weight"
method = "dda"
integrator = "implicit"
dt = 0.05
duration = 5.0
rest = true

[[stage]]
name = "slide"
method = "dda"
integrator = "implicit"
dt = "2 ms"
duration = 12.0
max_displacement = 1.0

[output]
every = 0.5
history_every = 0.05
"""


def foot(run, x):
    """A metre above the surface."""
    (cx, cy), radius, _ = arc(run)
    return cy - math.sqrt(radius**2 - (x - cx) ** 2) + 1.0


def moved(case, friction, between, single, scree, folder, duration=6.0):
    """Displacements of the monitors at the end of a run."""
    out = pathlib.Path(folder) / "run"
    set_ = ["joint.slip.friction_deg=%r" % friction, "joint.slices.friction_deg=%r" % between, "stage.1.duration=%r" % duration]
    if single:
        set_.append("domain.trace=[]")
    command = [scree, "run", str(case), "--out", str(out), "--quiet", "--threads", "1"]
    for s in set_:
        command += ["--set", s]
    subprocess.run(command, check=True, capture_output=True)
    summary = json.loads((out / "summary.json").read_text())
    return max(b["displacement"] for b in summary["blocks"])


def required(between, single, scree, limit_way=0.5):
    low, high = 20.0, 75.0
    with tempfile.TemporaryDirectory() as folder:
        while high - low > 0.125:
            f = 0.5 * (low + high)
            subprocess.run(["rm", "-rf", os.path.join(folder, "run")], check=True)
            low, high = (f, high) if moved(HERE.parent / "case.toml", f, between, single, scree, folder) > limit_way else (low, f)
    return 0.5 * (low + high)


if __name__ == "__main__":
    check()
    run = calibrated()
    if "--write" in sys.argv:
        (HERE.parent / "case.toml").write_text(case_text(run))
    elif "--required" in sys.argv:
        scree = os.environ.get("SCREE", str(HERE.parents[2] / "build/release/app/scree"))
        print(f"one block: {required(5.0, True, scree):.2f} degrees")
        for between in (5.0, 10.0, 20.0, 30.0, 40.0):
            print(f"{SLICES} slices, {between:g} degrees between them: {required(between, False, scree):.2f} degrees")
    else:
        (_, _), radius, dip = arc(run)
        print(f"arc from (0, 0) to ({run:g}, {HEIGHT:g}) m, radius {radius:.2f} m, chord of {math.degrees(dip):.2f} degrees")
        print(f"friction of one block: {limit(run):.2f} degrees on springs, {limit(run, True):.2f} on its two ends")
