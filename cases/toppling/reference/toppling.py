"""A rigid block on a plane of 30 degrees that slides, topples, does both or stands: its motion from rest; checks itself, prints toppling.csv.

usage: toppling.py           prints the slip of the toe and the rise of the heel, in time, of every run of the case
       toppling.py --chart   prints the regimes in the plane of friction and slenderness
       toppling.py --write   writes ../expected.toml

Axes: x down the plane, y out of it, origin at the toe, which is the lower front corner; width b, height h = 2 m, d = b/h. The toe has slipped s, the block has
turned forward by w. The centre lies at (p, q) from the toe, p = h/2 sin w - b/2 cos w, q = b/2 sin w + h/2 cos w, so that
  m (s'' + q w'' - p w'^2) = m g sin a - F,   m (-p w'' - q w'^2) = N - m g cos a,   I w'' = p N + q F,   I = m (b^2 + h^2)/12
with F = N tan phi while it slips, s'' = 0 while it does not. A block that slides without turning: s'' = g (sin a - cos a tan phi).
It turns from the start where it would turn over a toe that friction holds and does not slip (d < tan a), or slips (d < tan phi).
"""
import math
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
SLOPE, GRAVITY, HEIGHT = math.radians(30.0), 9.81, 2.0
TIME, EVERY, STEP = 0.3, 0.01, 1e-4


def critical(d):
    """Friction [deg] below which a block that topples slides too."""
    t = math.tan(SLOPE)
    return math.degrees(math.atan((3 * d + (1 + 4 * d * d) * t) / (3 * d * t + 4 + d * d)))


def regime(d, phi):
    slope = math.degrees(SLOPE)
    if d < math.tan(SLOPE) and phi >= critical(d):
        return "topples"
    if phi < slope:
        return "slides" if d >= math.tan(math.radians(phi)) else "both"
    return "stands" if d >= math.tan(SLOPE) else "topples"


def rates(state, d, mu, slips):
    """s'', w'' and F/N of a block on its toe, unit mass."""
    _, w, _, spin = state
    b = d * HEIGHT
    p, q = 0.5 * (HEIGHT * math.sin(w) - b * math.cos(w)), 0.5 * (b * math.sin(w) + HEIGHT * math.cos(w))
    inertia = (b * b + HEIGHT * HEIGHT) / 12.0
    pull, load = GRAVITY * math.sin(SLOPE), GRAVITY * math.cos(SLOPE)
    if slips:  # N = load - p w'' - q w'^2 in I w'' = (p + mu q) N
        lever = p + mu * q
        turn = lever * (load - q * spin**2) / (inertia + lever * p)
        n = load - p * turn - q * spin**2
        assert n > 0.0
        return pull - mu * n - q * turn + p * spin**2, turn, mu
    turn = (q * pull + p * load) / (inertia + p * p + q * q)
    n, f = load - p * turn - q * spin**2, pull - q * turn + p * spin**2
    return 0.0, turn, f / n


def advance(state, d, mu, slips, step):
    """A Runge-Kutta step."""
    def slope(s):
        acceleration, turn, _ = rates(s, d, mu, slips)
        return s[2], s[3], acceleration, turn

    def along(s, k, h):
        return tuple(x + h * y for x, y in zip(s, k))

    k1 = slope(state)
    k2 = slope(along(state, k1, 0.5 * step))
    k3 = slope(along(state, k2, 0.5 * step))
    k4 = slope(along(state, k3, step))
    return tuple(x + step / 6.0 * (a + 2 * b + 2 * c + e) for x, a, b, c, e in zip(state, k1, k2, k3, k4))


def motion(d, phi, step=STEP):
    """Slip of the toe and rise of the heel [m], every EVERY, from rest."""
    mu, kind = math.tan(math.radians(phi)), regime(d, phi)
    state, slips, out = (0.0, 0.0, 0.0, 0.0), kind == "both", [(0.0, 0.0)]
    per = round(EVERY / step)
    for i in range(round(TIME / step)):
        if kind in ("topples", "both"):
            if not slips:
                asked = rates(state, d, mu, False)[2]
                assert asked > -mu
                slips = asked > mu
            state = advance(state, d, mu, slips, step)
            if slips and state[2] < 0.0:    # the slip has ended
                state, slips = (state[0], state[1], 0.0, state[3]), False
            assert state[3] >= 0.0
        elif kind == "slides":
            state = (0.5 * GRAVITY * (math.sin(SLOPE) - math.cos(SLOPE) * mu) * ((i + 1) * step) ** 2, 0.0, 0.0, 0.0)
        if (i + 1) % per == 0:
            out.append((state[0], d * HEIGHT * math.sin(state[1])))
    return out


def check():
    assert abs(critical(0.3) - 20.1) < 0.05
    for d in (0.2, 0.3, 0.4):
        # On the border the friction required by a turning block equals the available friction.
        assert abs(rates((0.0, 0.0, 0.0, 0.0), d, 0.0, False)[2] - math.tan(math.radians(critical(d)))) < 1e-12
        # Both modes coincide there.
        mu = math.tan(math.radians(critical(d)))
        assert abs(rates((0.0, 0.0, 0.0, 0.0), d, mu, True)[0]) < 1e-12
    # A block that turns about a fixed toe: conservation of energy.
    d = 0.3
    state = (0.0, 0.0, 0.0, 0.0)
    for _ in range(3000):
        state = advance(state, d, 0.0, False, 1e-4)
    w, b = state[1], d * HEIGHT
    p, q = 0.5 * (HEIGHT * math.sin(w) - b * math.cos(w)), 0.5 * (b * math.sin(w) + HEIGHT * math.cos(w))
    gain = GRAVITY * (math.sin(SLOPE) * (p + 0.5 * b) - math.cos(SLOPE) * (q - 0.5 * HEIGHT))
    assert abs(gain - (b * b + HEIGHT * HEIGHT) / 6.0 * state[3] ** 2) < 1e-9, (gain, state)
    # Order of the stepping.
    exact = motion(0.3, 18.0, 5e-5)[-1]
    assert all(abs(x / y - 1.0) < 1e-9 for x, y in zip(motion(0.3, 18.0)[-1], exact))


SLENDERNESS, FRICTION = (0.2, 0.3, 0.4, 0.5, 0.8, 1.2), (10.0, 15.0, 18.0, 24.0, 35.0, 45.0)
HALF = 0.5  # distance to a border, on either side [deg]


def runs():
    grid = [(d, phi) for d in SLENDERNESS for phi in FRICTION]
    tan = lambda degrees: round(math.tan(math.radians(degrees)), 6)
    border = [(0.9, 30.0 + s * HALF) for s in (-1, 1)]                              # slides, stands
    border += [(tan(30.0 + s * HALF), 60.0) for s in (-1, 1)]                       # topples, stands
    border += [(tan(18.0 + s * HALF), 18.0) for s in (-1, 1)]                       # both, slides
    border += [(0.3, round(critical(0.3) + s * HALF, 6)) for s in (-1, 1)]          # both, topples
    return grid, border


def name(d, phi):
    return f"{d:g}-{phi:g}"


def print_table():
    grid, border = runs()
    histories = [motion(*r) for r in grid + border]
    print("# Slip of the toe and rise of the heel of a rigid block on a plane of 30 degrees, by toppling.py: width over height, friction.")
    print("time [s]" + "".join(f", slip-{name(*r)} [m], heel-{name(*r)} [m]" for r in grid + border))
    for i in range(len(histories[0])):
        print(f"{EVERY * i:.9g}" + "".join(f", {h[i][0]:.9g}, {h[i][1]:.9g}" for h in histories))


def print_chart():
    grid, _ = runs()
    print("| width/height | " + " | ".join(f"phi = {phi:g}" for phi in FRICTION) + " |")
    print("|---|" + "---|" * len(FRICTION))
    for d in SLENDERNESS:
        print(f"| {d:g} | " + " | ".join(regime(d, phi) for phi in FRICTION) + " |")


def expected_text():
    grid, border = runs()
    text = "# A block that slides, topples, does both or stands: a grid of the chart and half a degree on either side of its borders.\n# Written by reference/toppling.py --write.\n"
    for d, phi in grid + border:
        b = d * HEIGHT
        text += f"""
[[variant]]
name = "{name(d, phi)}"
set = ["block.block.polygon=[[{-b:.9g}, 0], [0, 0], [0, 2], [{-b:.9g}, 2]]", "monitor.heel.point=[{-b:.9g}, 0]", "joint.plane.friction_deg={phi!r}"]
"""
    for d, phi in grid + border:
        kind, (slip, heel) = regime(d, phi), motion(d, phi)[-1]
        for what, monitor, component, value in (("slip of the toe", "toe", "ux", slip), ("rise of the heel", "heel", "uy", heel)):
            moves = value > 0.0
            bound = f"reference = {value:.6g}\n{BOUND}" if moves else "at_most = 1e-5\nat_least = -1e-5\n"
            reason = "a rigid block" if moves else "none: elastic settling alone; half a degree beyond a border brings a millimetre and more"
            text += f"""
[[quantity]]
name = "{kind}, width/height {d:g}, friction {phi:g}: {what} [m]"
measure = "monitor"
variant = "{name(d, phi)}"
of = "{monitor}"
component = "{component}"
{bound}reason = "{reason}"
"""
    return text


BOUND = "tolerance = 0.01\n"

if __name__ == "__main__":
    check()
    if "--chart" in sys.argv:
        print_chart()
    elif "--write" in sys.argv:
        (HERE.parent / "expected.toml").write_text(expected_text())
    else:
        print_table()
