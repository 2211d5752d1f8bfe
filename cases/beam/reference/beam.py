"""Deflection of the beam at mid-height by beam theory with shear; prints beam.csv."""
LENGTH, DEPTH, LOAD, YOUNG, POISSON = 10.0, 1.0, 200.0, 1e5, 0.24
INERTIA, SHEAR = DEPTH**3 / 12.0, YOUNG / (2.0 * (1.0 + POISSON))
FACTOR = 5.0 / 6.0  # shear factor of a rectangle


def deflection(x):
    x = min(x, LENGTH - x)
    bending = LOAD * x * (3.0 * LENGTH**2 - 4.0 * x**2) / (48.0 * YOUNG * INERTIA)
    return -(bending + LOAD * x / (2.0 * FACTOR * SHEAR * DEPTH))


print("# Timoshenko beam: Euler's deflection P x (3 l^2 - 4 x^2)/(48 E I) and shear's P x/(2 k G A), k = 5/6. By beam.py.")
print("monitor, x [m], uy [m]")
for i in range(11):
    print(f"p{i}, {i}, {deflection(i):.9g}")
