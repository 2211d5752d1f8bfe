"""A rigid block of 1 x 1 m on two corner springs on a plane of 30 degrees: the effect of switching gravity on at once.

Each corner stands for half of the base: normal and shear springs of k = 0.5 m (K + 4 G/3)/m, a dashpot beside the normal
one, Coulomb friction by return mapping. Axes: s down the slope, n along its normal, w the spin about the block's centre.
Prints the final slip of the block beyond the theory, and the friction impulse missing while its corners stick.
"""
import math

MASS, GRAVITY, SLOPE = 2500.0, 9.81, math.radians(30.0)
STIFFNESS = 0.5 * 5e9 * 0.75 / (1.25 * 0.5)  # half of the P-wave modulus, E = 5 GPa, nu = 0.25


def slide(phi, damping, onset, duration, step=2e-6):
    """Excess over the theory [m] and missing friction impulse over the mass [m/s]; gravity grows to its full value
    during onset [s]."""
    mu, inertia = math.tan(math.radians(phi)), MASS / 6.0
    dashpot = damping * 2.0 * math.sqrt(STIFFNESS * MASS / 2.0)
    s = n = turn = vs = vn = w = 0.0
    shear, lacking = [0.0, 0.0], 0.0
    for i in range(round(duration / step)):
        weight = MASS * GRAVITY * (min(1.0, i * step / onset) if onset > 0.0 else 1.0)
        fs, fn, moment = weight * math.sin(SLOPE), -weight * math.cos(SLOPE), 0.0
        for corner, x in enumerate((-0.5, 0.5)):
            gap = n + turn * x
            if gap >= 0.0:
                shear[corner] = 0.0
                continue
            normal = max(0.0, -STIFFNESS * gap - dashpot * (vn + w * x))
            shear[corner] -= STIFFNESS * (vs + 0.5 * w) * step
            if abs(shear[corner]) > mu * normal:
                shear[corner] = math.copysign(mu * normal, shear[corner])
            else:
                lacking += (mu * normal + shear[corner]) * step / MASS
            fs += shear[corner]
            fn += normal
            moment += x * normal + 0.5 * shear[corner]
        vs += step * fs / MASS
        vn += step * fn / MASS
        w += step * moment / inertia
        s += step * vs
        n += step * vn
        turn += step * w
    pull = GRAVITY * (math.sin(SLOPE) - math.cos(SLOPE) * mu)
    return s - pull * ((duration - onset / 2.0) ** 2 / 2.0 + onset**2 / 24.0), lacking


for phi, damping, onset in ((5, 0.2, 0.0), (10, 0.2, 0.0), (20, 0.0, 0.0), (20, 0.2, 0.0), (20, 1.0, 0.0), (20, 0.2, 0.1)):
    beyond, lacking = slide(phi, damping, onset, 0.5 + onset / 2.0)
    print(f"phi {phi}, damping {damping:g}, gravity grown in {onset:g} s: {1e3 * beyond:.3f} mm too far,"
          f" friction lacks {1e3 * lacking:.3f} mm/s")
