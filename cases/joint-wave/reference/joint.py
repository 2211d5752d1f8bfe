"""Coefficients and transmitted peaks of a joint of stiffness k in rock of impedance z = rho c; prints joint.csv.

The stress s is equal on both sides of the joint, and the opening rate is the jump of velocity, s' = k (v_before -
v_behind).
With p_in the incoming stress, 2 p_in = s + z v_before and s = z v_behind: s' = a (p_in - s), a = 2 k/z = 2 K w.
So T(w) = 1/(1 + i w/a), |T| = sqrt(4 K^2/(4 K^2 + 1)), |R| = sqrt(1/(4 K^2 + 1)), and s >= 0 wherever p_in >= 0 before.
"""
import math


def crossed_half_sine(a, t):
    """s at time t for p_in = sin t up to pi, from the solution of s' = a (p_in - s) at rest; time in 1/w."""
    return a / (a * a + 1.0) * (a * math.sin(t) - math.cos(t) + math.exp(-a * t))


def crossed_sine_squared(a, t):
    """s at time t for p_in = sin^2(t/2) up to 2 pi."""
    q = a / (a * a + 1.0)
    return 0.5 * (1.0 - q * (a * math.cos(t) + math.sin(t)) - (1.0 - q * a) * math.exp(-a * t))


def peak(crossed, a, end, steps=200000):
    """While p_in lasts: where s is largest s' = 0, so s = p_in, and after p_in s only falls."""
    return max(crossed(a, end * i / steps) for i in range(steps + 1))


print("# |T| and |R| of a harmonic wave, and the peak of what crosses over that of the pulse sent in, by joint.py.")
print("K, T, R, peak of a half sine, peak of a sine squared")
for K in (0.1, 0.3, 1.0, 3.0, 12.0):
    root = math.sqrt(4.0 * K * K + 1.0)
    print(f"{K:g}, {2.0 * K / root:.6f}, {1.0 / root:.6f}, {peak(crossed_half_sine, 2.0 * K, math.pi):.6f},"
          f" {peak(crossed_sine_squared, 2.0 * K, 2.0 * math.pi):.6f}")
