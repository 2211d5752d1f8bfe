"""Four rigid blocks of 4 x 2 m on springs, by stepping; checks itself, prints four-blocks.csv.

Block i has the place x, y of its centre and a small turn w. Where two faces meet, their overlap is cut into POINTS equal pieces, each
with a normal and a shear spring of K per metre; open pieces carry no force, shear is limited to tan(phi) of the
normal force by return mapping. Springs carry no damping, steps are by velocity Verlet.
"""
import math

WIDTH, HEIGHT, DENSITY, GRAVITY = 4.0, 2.0, 2500.0, 9.81
K = 5e7  # [Pa/m]
MASS = DENSITY * WIDTH * HEIGHT
INERTIA = MASS * (WIDTH**2 + HEIGHT**2) / 12.0
PRESSURE, PULSE, PUSH = 1e6, 0.02, 1e6  # [Pa], [s], [N]
PUSHED, BLOCKS, POINTS = 2, 4, 16  # blocks count from the base up
STEP, EVERY, DURATION = 2e-5, 5e-4, 0.06


class Column:
    def __init__(self, phi_deg, push=PUSH, blocks=BLOCKS, points=POINTS):
        self.mu, self.push, self.blocks, self.points = math.tan(math.radians(phi_deg)), push, blocks, points
        self.time = 0.0
        self.q = []  # x, y, w of each block from its unloaded place
        sink = 0.0
        for i in range(blocks):
            sink += (blocks - i) * MASS * GRAVITY / (K * WIDTH)
            self.q.append([0.0, -sink, 0.0])
        self.start = [list(q) for q in self.q]
        self.v = [[0.0, 0.0, 0.0] for _ in range(blocks)]
        self.shear = [[0.0] * points for _ in range(blocks)]  # traction [Pa] below each block
        self.before = [None] * blocks
        self.a = self.accelerations()

    def accelerations(self):
        """Accelerations x, y, w of the blocks; updates the shear springs to the present places."""
        force = [[0.0, -MASS * GRAVITY, 0.0] for _ in range(self.blocks)]
        if self.blocks > PUSHED:
            force[PUSHED][0] += self.push
        if self.time < PULSE:
            load = PRESSURE * WIDTH * math.sin(math.pi * self.time / PULSE)
            force[-1][1] -= load
            force[-1][2] += load * 0.5 * HEIGHT * self.q[-1][2]  # the loaded face is beside the centre
        for i in range(self.blocks):
            lower = self.q[i - 1] if i > 0 else (0.0, 0.0, 0.0)
            upper = self.q[i]
            half = 0.5 * HEIGHT
            a, b = upper[0] + half * upper[2], lower[0] - (half if i > 0 else 0.0) * lower[2]  # middles of the faces
            left = a - 0.5 * WIDTH if i == 0 else max(a, b) - 0.5 * WIDTH
            right = a + 0.5 * WIDTH if i == 0 else min(a, b) + 0.5 * WIDTH
            length = (right - left) / self.points
            slip = a - b
            moved = slip - self.before[i] if self.before[i] is not None else 0.0
            self.before[i] = slip
            for p in range(self.points):
                x = left + (p + 0.5) * length
                gap = upper[1] - lower[1] + upper[2] * (x - upper[0]) - lower[2] * (x - lower[0])
                if gap >= 0.0:
                    self.shear[i][p] = 0.0
                    continue
                normal, limit = -K * gap, -self.mu * K * gap
                self.shear[i][p] = shear = max(-limit, min(limit, self.shear[i][p] - K * moved))
                fx, fy = shear * length, normal * length
                f = force[i]
                f[0] += fx
                f[1] += fy
                f[2] += (x - upper[0]) * fy + half * fx
                if i > 0:
                    f = force[i - 1]
                    f[0] -= fx
                    f[1] -= fy
                    f[2] -= (x - lower[0]) * fy - half * fx
        return [[f[0] / MASS, f[1] / MASS, f[2] / INERTIA] for f in force]

    def step(self, h):
        for v, a, q in zip(self.v, self.a, self.q):
            for c in range(3):
                v[c] += 0.5 * h * a[c]
                q[c] += h * v[c]
        self.time += h
        self.a = self.accelerations()
        for v, a in zip(self.v, self.a):
            for c in range(3):
                v[c] += 0.5 * h * a[c]

    def moved(self):
        return [[q[c] - s[c] for c in range(3)] for q, s in zip(self.q, self.start)]


def run(phi_deg, step=STEP, points=POINTS):
    """Displacements x, y, w of the blocks from their unloaded places, at intervals of EVERY from the beginning of the
    pulse."""
    column, out = Column(phi_deg, points=points), []
    each = round(EVERY / step)
    for i in range(round(DURATION / step) + 1):
        if i % each == 0:
            out.append([list(q) for q in column.q])
        column.step(step)
    return out


def one_block(t):
    """Sink of one block under the pulse, exact: u'' + k u = p sin(W t), then free (thesis 7.57), as long as the block
    stays in contact."""
    k, big = K * WIDTH / MASS, math.pi / PULSE
    w, p = math.sqrt(k), PRESSURE * WIDTH / MASS
    forced = lambda s: p / (k - big**2) * (math.sin(big * s) - big / w * math.sin(w * s))
    if t <= PULSE:
        return forced(t)
    u, v = forced(PULSE), p / (k - big**2) * big * (math.cos(math.pi) - math.cos(w * PULSE))
    return u * math.cos(w * (t - PULSE)) + v / w * math.sin(w * (t - PULSE))


def check():
    # One block against the exact solution, of order 2.
    errors = []
    for step in (2e-4, 1e-4):
        column, worst = Column(0.0, blocks=1), 0.0
        for _ in range(round(0.03 / step)):
            column.step(step)
            worst = max(worst, abs(column.moved()[0][1] + one_block(column.time)))
        errors.append(worst)
    assert errors[1] < 1e-3 * one_block(0.02) and 3.5 < errors[0] / errors[1] < 4.5, errors
    # Without friction the second block is free: u = F t^2/(2 m).
    free = run(0.0)[-1][PUSHED][0] / (0.5 * PUSH / MASS * DURATION**2) - 1.0
    assert abs(free) < 1e-9, free
    # Convergence with steps and pieces.
    for phi in (0.0, 45.0):
        found, finer = run(phi)[-1], run(phi, points=2 * POINTS)[-1]
        shorter = run(phi, 0.5 * STEP)[-1]
        for a, b, c in zip(found, finer, shorter):
            assert all(abs(a[k] - b[k]) < 5e-5 and abs(a[k] - c[k]) < 5e-5 for k in (0, 1)), (phi, a, b, c)


NAMES = ("I2", "I1", "E2", "E1")
BEFORE = 0.3  # gravity alone [s]


def main():
    phis = (0.0, 45.0)
    runs = [run(phi) for phi in phis]
    print("# Displacements of four rigid blocks on springs, gravity alone until 0.3 s, by four_blocks.py.")
    print("time [s]" + "".join(f", {c}-{n}-{phi:g} [m]" for phi in phis for n in NAMES for c in "xy"))
    for i in range(len(runs[0])):
        numbers = [moved[c] for r in runs for moved in r[i] for c in (0, 1)]
        print(f"{BEFORE + EVERY * i:.9g}" + "".join(f", {round(x, 9) + 0.0:.9g}" for x in numbers))


if __name__ == "__main__":
    check()
    main()
