"""A sine-squared pulse in a bar with a free end, by d'Alembert's solution and an image; prints bar.csv."""
import math

LENGTH, SPEED, DENSITY, PRESSURE, DURATION = 2.0, 5000.0, 2650.0, 1e6, 2e-4
PLACES = (0.5, 1.0, 1.5, 2.0)


def pulse(t):
    return math.sin(math.pi * t / DURATION) ** 2 if 0.0 <= t <= DURATION else 0.0


print("# One-dimensional wave, free end at 2 m: velocity (p(t - x/c) + p(t - (4 m - x)/c))/(rho c),"
      " stress -p(t - x/c) + p(t - (4 m - x)/c).")
print("# By bar.py.")
print("time [s]" + "".join(f", vx-x{x:g} [m/s], sxx-x{x:g} [Pa]" for x in PLACES))
for i in range(601):
    t, row = 1e-6 * i, []
    for x in PLACES:
        there, back = pulse(t - x / SPEED), pulse(t - (2.0 * LENGTH - x) / SPEED)
        row += [PRESSURE / (DENSITY * SPEED) * (there + back), PRESSURE * (back - there)]
    print(f"{t:.9g}" + "".join(f", {value:.9g}" for value in row))
