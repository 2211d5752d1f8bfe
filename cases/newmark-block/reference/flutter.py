"""Steady sliding of a block that deforms is not always stable: growth of its oscillation by linear theory, without time
steps of Scree.

A block with affine displacements slides down a plane on its two base corners, each a normal spring k of half the base and a
dashpot, with Coulomb friction mu N against the slip. Unknowns: the lift n of the centre, the turn r, the strains ex, ey, g;
mass and elastic stiffness are those of the affine field, J_n and J_s the rows of lift and slip of a corner. With
  M x'' + sum (J_n - mu J_s)^T c J_n x' + (K + sum (J_n - mu J_s)^T k J_n) x = 0
friction makes the matrices unsymmetric: two modes whose frequencies coincide flutter. The growth is measured on the
linear equations, by Runge-Kutta steps. Prints it for blocks of 1 x 1 and 2 x 1 m, E = 5 GPa; frequencies and rates
scale with sqrt(E).
"""
import math

YOUNG, POISSON, RHO = 5e9, 0.25, 2500.0
LAME, SHEAR = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON)), YOUNG / (2 * (1 + POISSON))
P_WAVE = LAME + 2.0 * SHEAR  # K + 4 G/3


def solve(A, B):
    """A^-1 B by elimination with pivots."""
    n = len(A)
    rows = [a[:] + b[:] for a, b in zip(A, B)]
    for i in range(n):
        pivot = max(range(i, n), key=lambda r: abs(rows[r][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [x / rows[i][i] for x in rows[i]]
        for r in range(n):
            if r != i:
                rows[r] = [x - rows[r][i] * y for x, y in zip(rows[r], rows[i])]
    return [row[n:] for row in rows]


def growth(length, phi_deg, damping):
    """Rate of the fastest growing oscillation [1/s]; negative: it dies out. Damping: fraction of critical, for a corner alone."""
    mu, mass, height = math.tan(math.radians(phi_deg)), RHO * length, 1.0
    xx, yy, volume = mass * length**2 / 12.0, mass * height**2 / 12.0, length * height
    k = 0.5 * length * P_WAVE / height
    # x = n, r, ex, ey, g: u_s = -y r + x ex + y g/2, u_n = n + x r + y ey + x g/2.
    M = [[mass, 0, 0, 0, 0], [0, xx + yy, 0, 0, 0.5 * (xx - yy)], [0, 0, xx, 0, 0], [0, 0, 0, yy, 0], [0, 0.5 * (xx - yy), 0, 0, 0.25 * (xx + yy)]]
    K = [[0.0] * 5 for _ in range(5)]
    K[2][2] = K[3][3] = volume * P_WAVE
    K[2][3] = K[3][2] = volume * LAME
    K[4][4] = volume * SHEAR
    C = [[0.0] * 5 for _ in range(5)]
    y = -0.5 * height
    for x in (-0.5 * length, 0.5 * length):
        lift, slip = [1.0, x, 0.0, y, 0.5 * x], [0.0, -y, x, 0.0, 0.5 * y]
        compliance = sum(a * b[0] for a, b in zip(lift, solve(M, [[a] for a in lift])))
        c = damping * 2.0 * math.sqrt(k / compliance)
        for i in range(5):
            for j in range(5):
                push = (lift[i] - mu * slip[i]) * lift[j]
                K[i][j] += k * push
                C[i][j] += c * push
    K, C = solve(M, K), solve(M, C)

    def rate(z):
        return z[5:] + [-sum(a * b for a, b in zip(K[i], z)) - sum(a * b for a, b in zip(C[i], z[5:])) for i in range(5)]

    def norm(z):
        return math.sqrt(sum((6000.0 * a) ** 2 for a in z[:5]) + sum(a * a for a in z[5:]))

    z, step, logs, total = [1e-6, 2e-6, -1e-6, 3e-6, 1e-6] + [0.0] * 5, 2e-5, [], 0.0
    for i in range(20000):
        a = rate(z)
        b = rate([p + 0.5 * step * q for p, q in zip(z, a)])
        c = rate([p + 0.5 * step * q for p, q in zip(z, b)])
        d = rate([p + step * q for p, q in zip(z, c)])
        z = [p + step / 6.0 * (q + 2.0 * r + 2.0 * s + t) for p, q, r, s, t in zip(z, a, b, c, d)]
        size = norm(z)
        total += math.log(size)
        z = [p / size for p in z]
        logs.append(total)
    # Slope over the last half of 0.4 s.
    first, last = logs[len(logs) // 2], logs[-1]
    return (last - first) / (step * (len(logs) - 1 - len(logs) // 2))


for length in (1.0, 2.0):
    for phi in (33.0, 35.0):
        print(f"{length:g} x 1 m, phi = {phi:g}: " + ", ".join(f"{growth(length, phi, d):.0f} ({d:g})" for d in (0.0, 0.05, 0.2, 1.0)) + " 1/s (damping)")
