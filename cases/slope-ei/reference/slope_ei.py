"""Displacement of rigid blocks that slide together on a plane of 41 degrees while gravity grows; prints slope-ei.csv.

All blocks have the same acceleration a f(t), a = g (sin 41 - cos 41 tan 5), f(t) = min(1, t/T), so that no block pushes
another. The closed form u = a t^3/(6 T) up to T, then a ((t - T/2)^2/2 + T^2/24), is checked by stepping.
"""
import math

GRAVITY, SLOPE, FRICTION, ONSET = 9.81, math.radians(41.0), math.radians(5.0), 0.1
PULL = GRAVITY * (math.sin(SLOPE) - math.cos(SLOPE) * math.tan(FRICTION))


def slide(t):
    if t <= ONSET:
        return PULL * t**3 / (6.0 * ONSET)
    return PULL * ((t - 0.5 * ONSET) ** 2 / 2.0 + ONSET**2 / 24.0)


def check(step=1e-4):
    u = v = 0.0
    for i in range(round(1.0 / step)):
        a = PULL * min(1.0, (i + 0.5) * step / ONSET)
        u += v * step + 0.5 * a * step**2
        v += a * step
        t = (i + 1) * step
        assert abs(u - slide(t)) < 1e-7, (t, u, slide(t))


check()
print("# Displacement of a rigid train of blocks, gravity grown in 0.1 s, by slope_ei.py.")
print("time [s], u [m]")
for i in range(201):
    print(f"{0.005 * i:.9g}, {slide(0.005 * i):.9g}")
