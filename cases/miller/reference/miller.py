"""|T|, |R| and A of a harmonic shear wave at a cohesive joint; checks itself, prints miller.csv.

Stress tau and velocity v of a plane wave travel unchanged at c, tau = rho c v. A joint between equal half-spaces
transmits v_t = tau/(rho c) and reflects v_r = v_i - tau/(rho c), and its faces slip at the rate 2 (v_i - v_t)
(d'Alembert). With v_i = V sin wt, tau bounded by the cohesion c_j and nothing elastic in the joint, v_t is the sine cut
off at +-a V, a = c_j/(rho c V). Roots of the parts of the energy, phi = asin a, over a quarter of a period (the sine
has pi/4):
  T^2 = [int_0^phi sin^2 + a^2 (pi/2 - phi)]/(pi/4),  R^2 = int_phi^(pi/2) (sin - a)^2/(pi/4),  A^2 = 1 - T^2 - R^2
Spring and slider: tau' = k (2 (v_i - tau/(rho c)) - slip rate), |tau| <= c_j, stepped by the trapezoidal rule.
"""
import math


def rigid(a):
    phi = math.asin(a)
    passed = 0.5 * phi - 0.25 * math.sin(2.0 * phi) + a * a * (0.5 * math.pi - phi)
    # int (sin - a)^2 from phi to pi/2 = int sin^2 - 2 a cos(phi) + a^2 (pi/2 - phi)
    back = 0.5 * (0.5 * math.pi - phi) + 0.25 * math.sin(2.0 * phi) - 2.0 * a * math.cos(phi) + a * a * (0.5 * math.pi - phi)
    T2, R2 = passed / (0.25 * math.pi), back / (0.25 * math.pi)
    return math.sqrt(T2), math.sqrt(max(0.0, R2)), math.sqrt(max(0.0, 1.0 - T2 - R2))


def spring_and_slider(a, K, periods=6, steps=20000):
    """The same with a spring k = K rho c w, in the last period; A from the work of slip, not from the remainder."""
    dt = 2.0 * math.pi / steps  # time in 1/w, stress in rho c V
    tau, before, sent, back, slid = 0.0, 0.0, 0.0, 0.0, 0.0
    for i in range(1, periods * steps + 1):
        v = math.sin(dt * i)
        trial = (tau * (1.0 - K * dt) + K * dt * (v + before)) / (1.0 + K * dt)
        now = max(-a, min(a, trial))
        if i > (periods - 1) * steps:
            sent += now * now
            back += (v - now) ** 2
            slid += abs(now * (trial - now)) * (1.0 + K * dt) / (K * dt)
        tau, before = now, v
    whole = 0.5 * steps
    return math.sqrt(sent / whole), math.sqrt(back / whole), math.sqrt(slid / whole)


def check():
    for a in (0.8, 0.5, 0.2, 0.05):
        for found, wanted in zip(spring_and_slider(a, 3000.0), rigid(a)):
            assert abs(found - wanted) < 3e-4, (a, found, wanted)
        T, R, A = spring_and_slider(a, 50.0)
        assert abs(T * T + R * R + A * A - 1.0) < 1e-4, (a, T, R, A)
    assert abs(rigid(1.0)[0] - 1.0) < 1e-12 and rigid(1.0)[1] < 1e-7 and rigid(1e-9)[1] > 1.0 - 1e-8


if __name__ == "__main__":
    check()
    print("# Roots of the parts of a harmonic wave's energy that a cohesive joint sends on, back and takes, by miller.py;")
    print("# a = c_j/(rho c V), rigid joint and one with a spring k = 50 rho c w.")
    print("a, T, R, A, T of the spring, R of the spring, A of the spring")
    for a in (0.8, 0.5, 0.2, 0.05):
        print(f"{a:g}, " + ", ".join(f"{x:.6f}" for x in rigid(a) + spring_and_slider(a, 50.0)))
