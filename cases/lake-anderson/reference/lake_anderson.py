"""A rigid block with cohesion on a plane of 26 degrees whose ground is shaken along x: slip by integration; checks itself, prints lake-anderson.csv.

usage: lake_anderson.py            prints slip in time for the synthetic record, both signs
       lake_anderson.py --motion   prints the synthetic record, shaking.csv
       lake_anderson.py --records  prints the slip for the three records in the folder SCREE_RECORDS, both signs, as recorded and scaled to 0.345 g
       lake_anderson.py --write    writes ../case.toml

In the frame of the ground, which accelerates by a along +x, the direction in which the plane falls, a force -a per mass
acts on the block:
  s'' = g sin B - a cos B - (g cos B + a sin B) tan phi - c L/m    while it slides down.
It never slides up. Between samples a and s'' are linear, so that velocity, slip and the roots where the block starts
and stops are exact.
"""
import math
import os
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[2] / "tools"))
from synthetic_record import scaled, sines  # noqa: E402

SLOPE, FRICTION, FACTOR = math.radians(26.0), math.radians(25.0), 1.492
GRAVITY = 9.80665
COHESION = 300.0 * 47.880259                 # 300 psf [Pa]
UNIT_WEIGHT = 22e3                           # [N/m3]
LENGTH = 20.0                                # of the plane under the block [m]
# The factor of safety tan phi/tan B + c L/(W sin B) determines the weight per metre of the plane, and so the thickness.
WEIGHT = COHESION / ((FACTOR - math.tan(FRICTION) / math.tan(SLOPE)) * math.sin(SLOPE))
THICKNESS = WEIGHT / UNIT_WEIGHT
HOLD = COHESION / (WEIGHT / GRAVITY)         # c L/m [m/s2]
PEAK, STEP, DURATION = 0.345, 0.005, 10.0
EVERY = 0.01


def slide(times, ground):
    """Slip at the samples [m]; ground: acceleration [m/s2], straight between samples."""
    mu = math.tan(FRICTION)

    def pull(a):
        return GRAVITY * math.sin(SLOPE) - a * math.cos(SLOPE) - (GRAVITY * math.cos(SLOPE) + a * math.sin(SLOPE)) * mu - HOLD

    def upward(a):
        return GRAVITY * math.sin(SLOPE) - a * math.cos(SLOPE) + (GRAVITY * math.cos(SLOPE) + a * math.sin(SLOPE)) * mu + HOLD

    s = v = 0.0
    out = [0.0]
    for t0, t1, g0, g1 in zip(times, times[1:], ground, ground[1:]):
        assert upward(g1) > 0.0 and GRAVITY * math.cos(SLOPE) + g1 * math.sin(SLOPE) > 0.0
        rest, a, rate = t1 - t0, pull(g0), (pull(g1) - pull(g0)) / (t1 - t0)
        while rest > 0.0:
            if v == 0.0 and (a < 0.0 or (a == 0.0 and rate <= 0.0)):
                wait = -a / rate if rate > 0.0 else math.inf    # until it starts
                if wait >= rest:
                    break
                rest, a = rest - wait, 0.0
            go = first_stop(v, a, rate, rest)
            s += v * go + 0.5 * a * go**2 + rate * go**3 / 6.0
            v = 0.0 if go < rest else max(0.0, v + a * go + 0.5 * rate * go**2)
            a += rate * go
            rest -= go
        out.append(s)
    return out


def first_stop(v, a, rate, rest):
    """First time after 0 at which v + a t + rate t^2/2 = 0, or rest."""
    inside = a * a - 2.0 * rate * v
    if inside < 0.0:
        return rest
    q = -(a + math.copysign(math.sqrt(inside), a))
    roots = [r for r in ((2.0 * v / q if q != 0.0 else -1.0), (q / rate if rate != 0.0 else -1.0)) if r > 1e-12]
    return min([rest, *roots])


def synthetic():
    """Samples [g]: eight sines under an envelope that rises in 2 s and dies away; phases from a Lehmer generator with
    seed 1979."""
    envelope = lambda t: (t / 2.0) ** 2 * math.exp(2.0 - t) if t > 0.0 else 0.0
    raw = sines((0.7, 1.1, 1.6, 2.3, 3.1, 4.3, 5.9, 7.7), 1979, STEP, DURATION, envelope)
    return scaled([x * min(1.0, (DURATION - i * STEP) / 1.0) for i, x in enumerate(raw)], PEAK)


def read(file):
    rows = [line.split(",") for line in pathlib.Path(file).read_text().splitlines()[1:]]
    return [float(r[0]) for r in rows], [float(r[1]) for r in rows]


RECORDS = ("gilroy6-230", "gilroy2-140", "coyote-dam-250")


def check():
    # The critical acceleration along the plane given by the source, and the corresponding horizontal one.
    assert abs((FACTOR - 1.0) * math.sin(SLOPE) - 0.2157) < 5e-5
    critical = (FACTOR - 1.0) * math.sin(SLOPE) / (math.cos(SLOPE) + math.sin(SLOPE) * math.tan(FRICTION))
    assert abs(critical - 0.1955) < 5e-5
    # A block under a constant acceleration for one second, then until it stops: closed form.
    over = 0.3 - critical
    scale = GRAVITY * (math.cos(SLOPE) + math.sin(SLOPE) * math.tan(FRICTION))
    times = [0.0, 1e-9, 1.0, 1.0 + 1e-9, 4.0]
    found = slide(times, [0.0, -0.3 * GRAVITY, -0.3 * GRAVITY, 0.0, 0.0])[-1]
    exact = 0.5 * over * scale * (1.0 + over / critical)
    assert abs(found / exact - 1.0) < 1e-7, (found, exact)
    # Newmark's closed form of one cycle of a sine, fine samples: from asin(c/A) to where the velocity is zero again.
    a, c, w = 0.5 * scale, critical * scale, 2.0 * math.pi
    t1 = math.asin(c / a) / w

    def velocity(t):
        return a / w * (math.cos(w * t1) - math.cos(w * t)) - c * (t - t1)

    low, high = 0.5 - t1, 1.0 + t1
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if velocity(middle) > 0.0 else (low, middle)
    exact = a / w * math.cos(w * t1) * (low - t1) - a / w**2 * (math.sin(w * low) - math.sin(w * t1)) - 0.5 * c * (low - t1) ** 2
    errors = []
    for n in (500, 1000):
        times = [1.2 * i / n for i in range(n + 1)]
        errors.append(abs(slide(times, [-0.5 * GRAVITY * math.sin(w * t) if t <= 1.0 else 0.0 for t in times])[-1] / exact - 1.0))
    assert errors[1] < 1e-4 and 3.0 < errors[0] / errors[1] < 5.0, errors


def times_of(samples):
    return [i * STEP for i in range(len(samples))]


def print_slips():
    samples = synthetic()
    slips = [slide(times_of(samples), [sign * GRAVITY * x for x in samples]) for sign in (1.0, -1.0)]
    print("# Slip u down the plane of a rigid block, and y = -u sin 26, for shaking.csv and its negative, by lake_anderson.py. Gravity alone until 0.1 s.")
    print("time [s], u+ [m], y+ [m], u- [m], y- [m]")
    print("0, 0, 0, 0, 0")
    per = round(EVERY / STEP)
    for i in range(0, len(samples), per):
        print(f"{0.1 + i * STEP:.9g}" + "".join(f", {s[i]:.9g}, {-s[i] * math.sin(SLOPE):.9g}" for s in slips))


def print_motion():
    print("# Synthetic record, peak 0.345 g, by reference/lake_anderson.py --motion.")
    print("time [s], acceleration [g]")
    for i, x in enumerate(synthetic()):
        print(f"{i * STEP:.3f}, {x:.6f}")


def recorded(name, sign, scaled):
    times, ground = read(os.path.join(os.environ["SCREE_RECORDS"], f"coyote-lake-1979-{name}.csv"))
    factor = sign * GRAVITY * (PEAK / max(map(abs, ground)) if scaled else 1.0)
    return slide(times, [factor * x for x in ground])[-1]


def print_records():
    print("record, peak [g], slip as recorded + - [mm], scaled to 0.345 g + - [mm]")
    for name in RECORDS:
        _, ground = read(os.path.join(os.environ["SCREE_RECORDS"], f"coyote-lake-1979-{name}.csv"))
        print(f"{name}, {max(map(abs, ground)):.3f}" + "".join(f", {1e3 * recorded(name, sign, scaled):.3f}" for scaled in (False, True) for sign in (1.0, -1.0)))


def case_text():
    t = math.tan(SLOPE)
    down, out = (math.cos(SLOPE), -math.sin(SLOPE)), (math.sin(SLOPE), math.cos(SLOPE))
    width, top = 34.0, 34.0 * t
    start = 4.0                              # of the block, from the crest of the plane along it [m]
    corners = []
    for along, off in ((start, 0.0), (start + LENGTH, 0.0), (start + LENGTH, THICKNESS), (start, THICKNESS)):
        corners.append((along * down[0] + off * out[0], top + along * down[1] + off * out[1]))
    middle = tuple(sum(c[i] for c in corners) / 4.0 for i in (0, 1))
    ring = ", ".join(f"[{x:.12g}, {y:.12g}]" for x, y in corners)
    return f"""# The slide at Lake Anderson: a block with cohesion on a plane of 26 degrees, whose ground is shaken. Written by reference/lake_anderson.py --write.
title = "Lake Anderson: a slide of 1979 under earthquake shaking"

[model]
gravity = [0, -{GRAVITY}]

[material.rock]
density = {UNIT_WEIGHT / GRAVITY:.9g}    # 22 kN/m3
young = "50 GPa"         # source: 1 GPa, which settles by 0.2 mm under its weight
poisson = 0.2

[joint.plane]
friction_deg = 25.0
cohesion = {COHESION:.9g}        # 300 psf; slip does not take it, as in Newmark's analysis
residual_cohesion = {COHESION:.9g}

[[block]]
name = "slope"
polygon = [[0, -4], [{width:g}, -4], [{width:g}, 0], [0, {top:.12g}]]
material = "rock"

[[block]]                # {LENGTH:g} m of plane, so thick that the factor of safety is {FACTOR}
name = "slide"
polygon = [{ring}]
material = "rock"

[[support]]
block = "slope"
motion = "earthquake"

[motion.earthquake]
file = "shaking.csv"
unit = "g"

[[monitor]]
name = "centre"
block = "slide"
point = [{middle[0]:.12g}, {middle[1]:.12g}]

[[stage]]                # statically
name = "gravity"
method = "dda"
integrator = "implicit"
dt = "10 ms"
duration = 0.1
rest = true

[[stage]]
name = "earthquake"
method = "dda"
integrator = "implicit"
dt = "1 ms"
duration = {DURATION}

[output]
every = 0.1
history_every = 0.01
"""


if __name__ == "__main__":
    check()
    if "--motion" in sys.argv:
        print_motion()
    elif "--records" in sys.argv:
        print_records()
    elif "--write" in sys.argv:
        (HERE.parent / "case.toml").write_text(case_text())
    else:
        print_slips()
