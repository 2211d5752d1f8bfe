"""Kirsch's stress along the axis across the tension; prints kirsch.csv."""
TENSION, RADIUS = 4e3, 0.1

print("# Kirsch: sigma_x = T/2 (2 + a^2/r^2 + 3 a^4/r^4) on the axis across the tension, r = a + distance. By kirsch.py.")
print("monitor, x [m], sxx [Pa]")
for distance in [0.05] + [0.1 * i for i in range(1, 9)]:
    ratio = (RADIUS / (RADIUS + distance)) ** 2
    stress = 0.5 * TENSION * (2.0 + ratio + 3.0 * ratio**2)
    print(f"above-{1000 * distance:.0f}mm, {distance:g}, {stress:.9g}")
