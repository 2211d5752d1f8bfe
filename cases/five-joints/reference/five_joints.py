"""Wave through parallel joints by characteristics; checks itself, prints five-joints.csv.

Stress s (compression positive) and velocity v of a bar travel as p = z v + s to the right and q = z v - s to the left,
z = rho c, unchanged between joints. s is equal on both sides of a joint, and its spring is s = k (closure), closure' =
v_before - v_behind. With p_in and q_in the waves that arrive, v_before = (p_in - s)/z and v_behind = (q_in + s)/z:
  s' = (k/z) (p_in - q_in - 2 s),  p_out = q_in + 2 s,  q_out = p_in - 2 s
A joint without strength has s = max(0, w), w' = (k/z) (p_in - q_in - 2 s): w = k (closure) is integrated further while
the joint is open.
Waves take the time S/c from one joint to the next, a whole number of steps; the trapezoidal rule errs by (k dt/z)^2/12.
"""
import cmath
import math

RHO, C, STIFFNESS, SPACING, JOINTS = 2650.0, 5000.0, 45e9, 0.2, 5
Z = RHO * C
STEP = 1e-7


def through_joints(incident, duration, count=JOINTS, stiffness=STIFFNESS, spacing=SPACING, opens=False, step=STEP):
    """Stress at the last joint at every step [Pa]; incident: stress of the wave that arrives at the first one at time
    0."""
    steps, delay, a = round(duration / step), round(spacing / C / step), stiffness / Z * step
    p = [[0.0] * (steps + 1) for _ in range(count)]
    q = [[0.0] * (steps + 1) for _ in range(count)]
    w, g = [0.0] * count, [0.0] * count
    out = [0.0] * (steps + 1)

    def arriving(j, i):
        from_left = 2.0 * incident(i * step) if j == 0 else (p[j - 1][i - delay] if i >= delay else 0.0)
        from_right = 0.0 if j == count - 1 or i < delay else q[j + 1][i - delay]
        return from_left, from_right

    for i in range(steps + 1):
        for j in range(count):
            p_in, q_in = arriving(j, i)
            drive = p_in - q_in
            if i > 0:
                held = max(w[j], 0.0) if opens else w[j]
                right = w[j] + 0.5 * a * (g[j] + drive) - a * held
                w[j] = right / (1.0 + a) if right > 0.0 or not opens else right
            g[j] = drive
            s = max(w[j], 0.0) if opens else w[j]
            p[j][i], q[j][i] = q_in + 2.0 * s, p_in - 2.0 * s
            if j == count - 1:
                out[i] = s
    return out


def harmonic(K, count, spacing_in_waves):
    """|T_N| by transfer matrices: each joint transmits 2 K/(i + 2 K) and reflects the rest, waves change phase between
    joints."""
    t = 2.0 * K / (1j + 2.0 * K)
    r, turn = 1.0 - t, cmath.exp(-2j * math.pi * spacing_in_waves)
    m = [[1.0, 0.0], [0.0, 1.0]]
    for j in range(count):
        one = [[(t * t - r * r) / t, r / t], [-r / t, 1.0 / t]]
        if j > 0:
            one = [[row[0] * turn, row[1] / turn] for row in one]
        m = [[sum(one[a][k] * m[k][b] for k in range(2)) for b in range(2)] for a in range(2)]
    back = -m[1][0] / m[1][1]
    return abs(m[0][0] + m[0][1] * back)


# |T_N| for joints 0.1 wavelengths apart, N = 1 to 5: values that were worked out before this program, independently of it.
TABLE = {1.0: (0.894427, 0.888984, 0.999529, 0.900294, 0.884004), 2.0: (0.970143, 0.949336, 0.982723, 0.996683, 0.958757)}


def check():
    """Transfer matrices against the table, and the stepping against transfer matrices: a harmonic wave in the long run."""
    wave = 1.0 / C * 1.0  # period of a wave of 1 m
    for K, row in TABLE.items():
        for count, wanted in enumerate(row, 1):
            assert abs(harmonic(K, count, 0.1) - wanted) < 1e-6, (K, count, harmonic(K, count, 0.1))
            stiffness, step = K * Z * 2.0 * math.pi / wave, wave / 2000.0
            found = through_joints(lambda t: math.sin(2.0 * math.pi * t / wave), 30.0 * wave, count, stiffness, 0.1, False, step)
            # Amplitude by the Fourier integral over the last period.
            last = found[-2000:]
            size = abs(sum(s * cmath.exp(-2j * math.pi * i / 2000.0) for i, s in enumerate(last))) / 1000.0
            assert abs(size - wanted) < 2e-5, (K, count, size, wanted)


def half_sine(t):
    return 1e6 * math.sin(math.pi * t / 1e-4) if 0.0 <= t <= 1e-4 else 0.0


if __name__ == "__main__":
    check()
    # The pulse leaves x = 0 at time 0, joint 1 is at 1.0 m, the last at 1.8 m, the monitor at 1.85 m.
    end, before, behind = 1.0e-3, 1.0 / C, 0.05 / C
    late = round((before + behind) / STEP)
    bonded = through_joints(half_sine, end)
    opening = through_joints(half_sine, end, opens=True)
    print("# Velocity 5 cm behind five joints: stress of the last one over rho c, by five_joints.py.")
    print("time [s], bonded [m/s], opening [m/s]")
    for i in range(0, round(end / STEP) + 1, 20):
        s = [x[i - late] / Z if i >= late else 0.0 for x in (bonded, opening)]
        print(f"{i * STEP:.7g}, {s[0]:.9g}, {s[1]:.9g}")
