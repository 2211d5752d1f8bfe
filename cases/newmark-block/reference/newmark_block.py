"""Sliding of a rigid block on a shaken plane by stepping; checks itself, prints newmark-block.csv or, given --motion, shaking.csv.

Axes: s down the plane, n out of it. A horizontal force per mass b (+x, the plane falls towards +x) and gravity give
  pull p = g sin + b cos down the plane,  load q = g cos - b sin on it,
and a block that slides down has s'' = p - q tan(phi). It starts where that exceeds 0 and stops where its velocity reaches 0.
The acceleration is linear within a step, and starts and stops are located within it: errors decrease with the square of
the step.
"""
import math
import sys

SLOPE, GRAVITY = math.radians(31.47), 9.80665
STEP = 1e-4


def slide(acceleration, resistance, duration, step=STEP):
    """Slip every step [m] and the time of the last stop [s]; acceleration(t) while it slides down, resistance(t) against upward."""
    slip, velocity, stopped = [0.0], 0.0, 0.0
    a0 = acceleration(0.0)
    for i in range(round(duration / step)):
        a1 = acceleration((i + 1) * step)
        assert resistance((i + 1) * step) > 0.0, "the block would slide up"
        begin, a, rate, s = 0.0, a0, (a1 - a0) / step, slip[-1]
        if velocity == 0.0 and a0 <= 0.0 < a1:  # starts within the step
            begin, a = -a0 / rate, 0.0
        if velocity > 0.0 or a > 0.0 or a1 > 0.0:
            rest = step - begin
            end = velocity + a * rest + 0.5 * rate * rest**2
            if end <= 0.0:  # stops within the step: the first root of velocity + a t + rate t^2/2, without cancellation
                root = math.sqrt(a * a - 2.0 * rate * velocity)
                rest = 2.0 * velocity / (root - a) if a < 0.0 else -(a + root) / rate
                end, stopped = 0.0, i * step + rest
            s += velocity * rest + 0.5 * a * rest**2 + rate * rest**3 / 6.0
            velocity = end
        slip.append(s)
        a0 = a1
    return slip, stopped


def shaken(phi_deg, sign, duration, step=STEP):
    """a_H = sign 0.1 g sin(4 pi t), t <= 1 s, as a force on the block."""
    mu = math.tan(math.radians(phi_deg))
    sin, cos = math.sin(SLOPE), math.cos(SLOPE)

    def loads(t):
        b = sign * 0.1 * GRAVITY * math.sin(4.0 * math.pi * t) if t <= 1.0 else 0.0
        return GRAVITY * sin + b * cos, GRAVITY * cos - b * sin

    def down(t):
        pull, load = loads(t)
        return pull - mu * load

    def up(t):
        pull, load = loads(t)
        return pull + mu * load

    return slide(down, up, duration, step)


def cycle(amplitude, critical, frequency=1.0, step=STEP):
    """Slip of one cycle of s'' = amplitude sin(w t) - critical, all along the plane, by stepping."""
    w = 2.0 * math.pi * frequency
    return slide(lambda t: amplitude * math.sin(w * t) - critical, lambda t: 1.0, 1.25 / frequency, step)[0][round(1.0 / frequency / step)]


def closed_form(amplitude, critical, frequency=1.0):
    """The same: from w t1 = asin(critical/amplitude) to where (amplitude/w)(cos w t1 - cos w t2) = critical (t2 - t1)."""
    w = 2.0 * math.pi * frequency
    t1 = math.asin(critical / amplitude) / w

    def velocity(t):
        return amplitude / w * (math.cos(w * t1) - math.cos(w * t)) - critical * (t - t1)

    low, high = math.pi / w - t1, t1 + 1.0 / frequency  # fastest, and surely at rest
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if velocity(middle) > 0.0 else (low, middle)
    t = low - t1
    return amplitude / w * math.cos(w * t1) * t - amplitude / w**2 * (math.sin(w * low) - math.sin(w * t1)) - 0.5 * critical * t**2


# Slip per cycle [mm] at 1 Hz and 0.5 g by critical acceleration over g, worked out before this program.
TABLE = {0.1: 445.572, 0.25: 157.211, 0.4: 23.3246}


def check():
    """Closed form against the table, stepping against the closed form, and the order of the stepping."""
    for critical, wanted in TABLE.items():
        exact = closed_form(0.5 * GRAVITY, critical * GRAVITY)
        assert abs(1e3 * exact / wanted - 1.0) < 2e-6, (critical, exact)
        errors = [abs(cycle(0.5 * GRAVITY, critical * GRAVITY, step=step) / exact - 1.0) for step in (1e-2, 1e-3, STEP)]
        assert errors[2] < 1e-6 and all(60.0 < a / b < 160.0 for a, b in zip(errors, errors[1:])), (critical, errors)
    # The shaken block itself. With +, its first slide is one of those cycles: A = 0.1 g cos(phi - slope)/cos(phi).
    for phi in (33.0, 35.0):
        beyond, cos = math.radians(phi) - SLOPE, math.cos(math.radians(phi))
        exact = closed_form(0.1 * GRAVITY * math.cos(beyond) / cos, GRAVITY * math.sin(beyond) / cos, 2.0)
        found = shaken(phi, 1.0, 0.5)[0][-1]
        assert abs(found / exact - 1.0) < 1e-6, (phi, found, exact)


CASES = ((33.0, 1.0), (33.0, -1.0), (35.0, 1.0), (35.0, -1.0))
BEFORE, DURATION, EVERY = 0.1, 2.0, 0.01  # time of gravity alone, duration from the start of shaking, interval of output [s]



def print_slips():
    runs = [shaken(phi, sign, DURATION) for phi, sign in CASES]
    names = [f"{phi:g}{'+' if sign > 0.0 else '-'}" for phi, sign in CASES]
    print("# Slip u down the plane of a rigid block, and y = -u sin 31.47: gravity alone until 0.1 s, then shaken for 1 s, by newmark_block.py.")
    print("# At rest again at" + ",".join(f" {BEFORE + stopped:.4f}" for _, stopped in runs) + " s.")
    print("time [s]" + "".join(f", u-{name} [m], y-{name} [m]" for name in names))
    print("0" + ", 0, 0" * len(CASES))
    for i in range(round(DURATION / EVERY) + 1):
        slips = [slip[round(i * EVERY / STEP)] for slip, _ in runs]
        print(f"{BEFORE + i * EVERY:.9g}" + "".join(f", {u:.9g}, {-u * math.sin(SLOPE):.9g}" for u in slips))


def print_motion():
    print("# 0.1 g sin(4 pi t), g = 9.80665 m/s2, by reference/newmark_block.py --motion.")
    print("time [s], acceleration [m/s2]")
    for i in range(501):
        print(f"{0.002 * i:.3f}, {round(0.1 * GRAVITY * math.sin(4.0 * math.pi * 0.002 * i), 9) + 0.0:.9f}")


if __name__ == "__main__":
    check()
    print_motion() if "--motion" in sys.argv else print_slips()
