"""The chair of the case vaiont: its geometry, cuts, and the limit equilibrium of two blocks.

usage: vaiont.py             prints the friction that two blocks need, by place of the cut and friction between them; checks itself
       vaiont.py --write     writes ../case.toml (105 blocks) and ../expected.toml
       vaiont.py --required  bisects the friction that 1 to 105 blocks need, by runs of scree (some minutes)

Two rigid wedges, the upper on the back (angle b), the lower on the seat (angle s), a vertical cut between them. In the
limit the reaction of each plane is inclined by phi, the force P of the cut by phi_i, and the force components normal to
the two reactions give
  W1 sin(b - phi) = P cos(b - phi - phi_i),     W2 sin(phi - s) = P cos(phi_i + phi - s).
"""
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
BACK, SEAT = 37.0, 7.5                      # [deg]
CREST_X, TOE_X = -430.0, 780.0              # [m]; the break of the chair is the origin
CREST = (CREST_X, -CREST_X * math.tan(math.radians(BACK)))
TOE = (TOE_X, -TOE_X * math.tan(math.radians(SEAT)))
SURFACE = [(-300.0, 300.0), (0.0, 200.0), (300.0, 160.0)]  # between crest and toe
GORGE = (TOE_X + 250.0, -(TOE_X + 250.0) * math.tan(math.radians(SEAT)))
BANK = (GORGE[0] + 400.0, GORGE[1] + 400.0 * math.tan(math.radians(30.0)))
DEPTH = GORGE[1] - 150.0
FRICTION_BETWEEN = 30.0                     # friction angle of the joints between blocks [deg]
SOURCE = {1: "7 to 8", 2: "13 to 14", 3: "15", 9: "15 to 18", 23: "15", 105: "16"}


def height(line, x):
    for (x0, y0), (x1, y1) in zip(line, line[1:]):
        if x0 <= x <= x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    raise ValueError(x)


def area(begin, end):
    """Area of the slide between two verticals: exact, since both lines are straight between their corners."""
    top, bottom = [CREST, *SURFACE, TOE], [CREST, (0.0, 0.0), TOE]
    at = sorted({begin, end, *(x for x, _ in top + bottom if begin < x < end)})
    depth = [height(top, x) - height(bottom, x) for x in at]
    return sum(0.5 * (b - a) * (p + q) for a, b, p, q in zip(at, at[1:], depth, depth[1:]))


def required(cut, between):
    """Friction angle of the surface in the limit of two blocks [deg]."""
    upper, lower = area(CREST_X, cut), area(cut, TOE_X)
    b, s, i = (math.radians(a) for a in (BACK, SEAT, between))
    low, high = math.radians(1.0), math.radians(36.0)
    for _ in range(60):
        f = 0.5 * (low + high)
        if upper * math.sin(b - f) / math.cos(b - f - i) > lower * math.sin(f - s) / math.cos(i + f - s):
            low = f
        else:
            high = f
    return math.degrees(low)


def check():
    assert abs(area(CREST_X, TOE_X) - 153699.1) < 0.1
    # Without friction between blocks the two wedges balance where W1 tan(b - phi) = W2 tan(phi - s).
    f = math.radians(required(-40.0, 0.0))
    balance = area(CREST_X, -40.0) * math.tan(math.radians(BACK) - f) - area(-40.0, TOE_X) * math.tan(f - math.radians(SEAT))
    assert abs(balance) < 1e-6 * area(CREST_X, TOE_X)


def vertical(x):
    return [(x, -300.0), (x, 500.0)]


def evenly(count):
    return [CREST_X + 30.0 + 1140.0 * (i + 1) / (count + 1) + 0.37 for i in range(count)]


def bedding(distance):
    """A line parallel to the chair, at a normal distance above it."""
    b, s = math.radians(BACK), math.radians(SEAT)
    nb, ns = (math.sin(b), math.cos(b)), (math.sin(s), math.cos(s))
    det = nb[0] * ns[1] - nb[1] * ns[0]
    corner = (distance * (ns[1] - nb[1]) / det, distance * (nb[0] - ns[0]) / det)
    reach = 900.0
    return [(corner[0] - reach * math.cos(b), corner[1] + reach * math.sin(b)), corner,
            (corner[0] + reach * math.cos(s), corner[1] - reach * math.sin(s))]


CUTS = {1: [], 2: [vertical(-40.0)], 3: [vertical(-150.0), vertical(-20.0)],
        9: [vertical(x) for x in (-325.0, -220.0, -130.0, -40.0, 60.0, 180.0, 320.0, 470.0)],
        23: [vertical(x) for x in evenly(22)],
        105: [vertical(x) for x in evenly(28)] + [bedding(d) for d in (40.0, 80.0, 120.0, 160.0)]}


def points(line):
    return "[" + ", ".join(f"[{x:.2f}, {y:.2f}]" for x, y in line) + "]"


def traces(lines):
    return "[" + ", ".join(f'{{ joint = "rock", points = {points(line)} }}' for line in lines) + "]"


def case_text():
    base = [(CREST[0] - 100.0, CREST[1]), CREST, (0.0, 0.0), TOE, GORGE, BANK, (BANK[0], DEPTH), (CREST[0] - 100.0, DEPTH)]
    outline = [base[0], CREST, *SURFACE, TOE, GORGE, BANK, base[-2], base[-1]]
    cuts = "\n".join(f'[[domain.trace]]\njoint = "rock"\npoints = {points(line)}\n' for line in CUTS[105])
    return f"""# Idealised section through the slide of Vaiont, 105 blocks: a chair with a back of {BACK:g} and a seat of {SEAT:g} degrees.
# Written by reference/vaiont.py; expected.toml has the other numbers of blocks, from the same chair.
title = "Vaiont: 105 blocks on a chair"

[model]
default_joint = "rock"

[material.rock]
density = 2500.0
young = "10 GPa"
poisson = 0.2

[joint.slip]             # the surface
friction_deg = 12.0

[joint.rock]             # between blocks
friction_deg = {FRICTION_BETWEEN}

[domain]
outline = {points(outline)}
material = "rock"
prefix = "slide"

[[domain.region]]
name = "valley"
polygon = {points(base)}
joint = "slip"
cut = false

{cuts}
[[support]]
block = "valley-1"

[[monitor]]
name = "toe"
point = [655.5, -62.3]

[[monitor]]
name = "middle"
point = [101.5, 60.3]

[[monitor]]
name = "crest"
point = [-201.7, 200.3]

[output]
every = 1.0
history_every = 0.1

[[stage]]                # springs take up the weight; what does not stand slips meanwhile, without speed
name = "weight"
method = "dda"
integrator = "implicit"
dt = 0.1
duration = 10.0
rest = true
max_displacement = 5.0

[[stage]]
name = "slide"
method = "dda"
integrator = "implicit"
dt = "5 ms"
duration = 60.0
max_displacement = 5.0
"""


def expected_text(found):
    """Each number of blocks stands and moves on either side of what it needs; speed grows with the blocks."""
    out = ["# What 1 to 105 blocks on one chair need; the limit equilibrium of two blocks by reference/vaiont.py, which wrote this file."]
    for blocks, need in found.items():
        for state, angle in (("stands", need + 0.5), ("moves", need - 0.5)):
            out.append(f"""
[[variant]]
name = "{blocks}-{state}"
tier = "{'quick' if blocks <= 2 else 'full'}"
set = ['domain.trace={traces(CUTS[blocks])}', "joint.slip.friction_deg={angle:g}", "stage.1.duration=20.0"]""")
    for blocks in CUTS:
        out.append(f"""
[[variant]]
name = "{blocks}-at-12"
tier = "full"
set = ['domain.trace={traces(CUTS[blocks])}']""")
    out.append("""
[[variant]]
name = "weakening"
tier = "full"
set = ["joint.slip.friction_deg=13.5", "joint.slip.residual_friction_deg=6.0", "joint.slip.weakening_slip=100.0"]

[[variant]]
name = "2-explicit"
tier = "full"
set = ['domain.trace=%s', "joint.slip.friction_deg=%g", "stage.1.duration=20.0", 'stage.1.integrator="explicit"', 'stage.1.dt="auto"']
""" % (traces(CUTS[2]), found[2] - 0.5))
    for blocks, need in found.items():
        source = f"source {SOURCE[blocks]} degrees"
        why = {1: "the seat: what the chair was drawn for", 2: f"limit equilibrium {required(-40.0, FRICTION_BETWEEN):.2f} degrees"}
        for state, angle, bound in (("stands", need + 0.5, "at_most = 1.0"), ("moves", need - 0.5, "at_least = 5.0")):
            out.append(f"""[[quantity]]
name = "{blocks} {'block' if blocks == 1 else 'blocks'}, {angle:g} degrees: way in 20 s [m]"
measure = "drift_in_stage"
variant = "{blocks}-{state}"
of = "slide"
{bound}
reason = "{why.get(blocks, 'half a degree beside what was found')}; {source}"
""")
    out.append("""[[quantity]]
name = "1 block, 12 degrees: way in 60 s [m]"
measure = "drift_in_stage"
variant = "1-at-12"
of = "slide"
at_most = 1.0
reason = "it stands at 8 degrees"
""")
    order = list(CUTS)[1:]
    for fewer, more in zip(order, order[1:]):
        out.append(f"""[[quantity]]
name = "12 degrees: way of the toe in 60 s, {more} over {fewer} blocks"
measure = "monitor"
variant = "{more}-at-12"
over = "{fewer}-at-12"
of = "toe"
component = "u"
at_least = 1.01
reason = "the more the mass gives way at the break of the chair, the faster it goes, as the source finds"
""")
    out.append("""[[quantity]]
name = "slip weakening: largest speed of the toe [m/s]"
measure = "monitor"
variant = "weakening"
of = "toe"
component = "vx"
statistic = "max"
at_least = 20.0
at_most = 50.0
reason = "20 to 50 m/s are told of the slide of 1963"

[[quantity]]
name = "slip weakening: way of the toe in 60 s [m]"
measure = "monitor"
variant = "weakening"
of = "toe"
component = "u"
at_least = 350.0
at_most = 550.0
reason = "over 400 m in less than 60 s"

[[quantity]]
name = "2 blocks, explicit over implicit: way in 20 s"
measure = "drift_in_stage"
variant = "2-explicit"
over = "2-moves"
of = "slide"
reference = 1.0
tolerance = 0.02
reason = "the other integrator"

[[quantity]]
name = "105 blocks: the ledger leaves over"
measure = "ledger_closure"
variant = "105-at-12"
at_most = 1e-9
reason = "what Scree promises"
""")
    return "\n".join(out)


def by_runs():
    """Friction required by each number of blocks, to an eighth of a degree: below it they move by 2 m in 20 s."""
    found = {}
    with tempfile.TemporaryDirectory(prefix="scree-vaiont-") as folder:
        for blocks, lines in CUTS.items():
            low, high = 5.0, 20.0
            while high - low > 0.13:
                middle = 0.5 * (low + high)
                subprocess.run(["scree", "run", HERE.parent / "case.toml", "--out", folder + "/run", "--overwrite", "--quiet",
                                "--set", f"domain.trace={traces(lines)}", "--set", f"joint.slip.friction_deg={middle}",
                                "--set", "stage.1.duration=20.0"], check=True, stderr=subprocess.DEVNULL, env=dict(os.environ))
                way = json.loads(pathlib.Path(folder, "run/summary.json").read_text())["stages"][1]["farthest_displacement"]
                low, high = (middle, high) if way > 2.0 else (low, middle)
            found[blocks] = 0.5 * (low + high)
            print(f"{blocks:4} blocks: {found[blocks]:.1f} degrees; source {SOURCE[blocks]}", flush=True)
    return found


def main():
    check()
    if "--required" in sys.argv:
        by_runs()
        return
    if "--write" in sys.argv:
        (HERE.parent / "case.toml").write_text(case_text())
        (HERE.parent / "expected.toml").write_text(expected_text({1: 7.5, 2: 13.7, 3: 14.4, 9: 13.9, 23: 14.9, 105: 14.8}))
        return
    for between in (20.0, 30.0, 40.0):
        print(f"friction between blocks {between:g} degrees:",
              ", ".join(f"cut at {x:g} m {required(x, between):.2f}" for x in (-200.0, -120.0, -40.0)), "degrees")


if __name__ == "__main__":
    main()
