"""Displacement of a rigid block on a plane of 30 degrees, Coulomb friction, from rest; prints incline.csv."""
import math

GRAVITY, SLOPE = 9.81, math.radians(30.0)
FRICTIONS = (0.0, 5.0, 10.0, 20.0)

print("# g t^2/2 (sin 30 - cos 30 tan phi), g = 9.81 m/s2, by incline.py.")
print("time [s]" + "".join(f", u-{phi:g} [m]" for phi in FRICTIONS))
for i in range(101):
    t = 0.005 * i
    pull = [math.sin(SLOPE) - math.cos(SLOPE) * math.tan(math.radians(phi)) for phi in FRICTIONS]
    print(f"{t:.9g}" + "".join(f", {0.5 * GRAVITY * p * t * t:.9g}" for p in pull))
