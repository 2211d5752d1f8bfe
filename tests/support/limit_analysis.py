"""Factors of safety of rigid blocks by limit equilibrium and limit analysis, independent of Scree.

Forces in the joints that are at Coulomb's limit divided by F, and equilibrium of every block. Units: m, N, Pa, degrees; unit thickness. Run as a program it checks itself.

  plane_factor          block on a plane, with cohesion, water, k_h                      Hoek and Bray 1981, eq. 7.3
  face_block            the block of a slope with a face and a tension crack             Hoek and Bray 1981, eqs. 7.4 to 7.8
  culmann_height        height of a face that stands on the worst plane through its toe  Culmann 1875, in Taylor 1948
  two_wedge_factor      upper block on a steep plane, lower one on a flat plane, friction and cohesion between them
  goodman_bray          flexural columns on a stepped base: P_0 that holds the toe       Goodman and Bray 1976
  goodman_bray_factor   the F at which P_0 = 0
  stands                whether some forces in the joints of rigid blocks hold them: a linear programme, no point of application assumed
  columns_factor        the F of the same columns by it
"""

import math


def rad(degrees):
    return math.radians(degrees)


def bisect(f, low, high, tolerance=1e-12):
    """Root of a function that is positive at `low` and not at `high`."""
    assert f(low) > 0.0 >= f(high), (f(low), f(high))
    while high - low > tolerance * max(1.0, abs(low)):
        middle = 0.5 * (low + high)
        if f(middle) > 0.0:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def plane_factor(weight, dip, phi, length=0.0, c=0.0, uplift=0.0, thrust=0.0, k_h=0.0):
    s, k = math.sin(rad(dip)), math.cos(rad(dip))
    normal = max(0.0, weight * (k - k_h * s) - uplift - thrust * s)
    return (c * length + normal * math.tan(rad(phi))) / (weight * (s + k_h * k) + thrust * k)


def face_block(height, face, dip, crack, water, water_weight=9810.0):
    """Corners of the block (toe, foot of the crack, its top, crest), its area, length of its plane, uplift, thrust."""
    x_crack = (height - crack) / math.tan(rad(dip))
    corners = [(0.0, 0.0), (x_crack, height - crack), (x_crack, height), (height / math.tan(rad(face)), height)]
    corners = [p for i, p in enumerate(corners) if p != corners[i - 1]]
    length = (height - crack) / math.sin(rad(dip))
    return corners, area(corners), length, 0.5 * water_weight * water * length, 0.5 * water_weight * water**2


def area(corners):
    return 0.5 * sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(corners, corners[1:] + corners[:1]))


def centroid(corners):
    a = area(corners)
    pairs = list(zip(corners, corners[1:] + corners[:1]))
    return tuple(sum((p[i] + q[i]) * (p[0] * q[1] - q[0] * p[1]) for p, q in pairs) / (6.0 * a) for i in (0, 1))


def culmann_height(c, phi, gamma, face):
    """4 c sin b cos phi/(gamma (1 - cos(b - phi))); the worst plane dips (b + phi)/2."""
    return 4.0 * c / gamma * math.sin(rad(face)) * math.cos(rad(phi)) / (1.0 - math.cos(rad(face - phi)))


def two_wedge_factor(w1, dip1, phi1, w2, dip2, phi2, phi12, interface=90.0, l1=0.0, c1=0.0, l2=0.0, c2=0.0, l12=0.0, c12=0.0):
    """Blocks 1 (above, on a plane at dip1) and 2 (below, at dip2 < dip1), which slide towards +x; the joint between them dips
    `interface` degrees (90: upright), measured like the planes. Friction is at its limit, divided by F, on all three planes.
    The unknowns are the normal forces n1, n2, n12 and F; four equations."""
    t1, t2, t12 = (math.tan(rad(p)) for p in (phi1, phi2, phi12))
    a1, a2, b = rad(dip1), rad(dip2), rad(interface)
    # unit normals of the planes, out of the rock below; of the joint, from block 1 to block 2
    up1, down1 = (math.sin(a1), math.cos(a1)), (math.cos(a1), -math.sin(a1))
    up2, down2 = (math.sin(a2), math.cos(a2)), (math.cos(a2), -math.sin(a2))
    across, along = (math.sin(b), math.cos(b)), (-math.cos(b), math.sin(b))  # along: up the joint

    def excess(f):
        # block 1: n1 (up1 - t1/f down1) + n12 (-across + t12/f along) = w1 up + c1 l1/f down1 - c12 l12/f along
        m = [[up1[i] - t1 / f * down1[i], -across[i] + t12 / f * along[i]] for i in (0, 1)]
        r = [c1 * l1 / f * down1[i] - c12 * l12 / f * along[i] for i in (0, 1)]
        r[1] += w1
        det = m[0][0] * m[1][1] - m[0][1] * m[1][0]
        n12 = (m[0][0] * r[1] - m[1][0] * r[0]) / det
        if det <= 0.0 or n12 < 0.0 or t1 / f >= math.tan(a1):
            n12 = 0.0  # block 1 stands without block 2
        push = [n12 * across[i] - (t12 * n12 + c12 * l12) / f * along[i] for i in (0, 1)]  # on block 2
        n2 = -(push[0] * up2[0] + (push[1] - w2) * up2[1])
        drive = push[0] * down2[0] + (push[1] - w2) * down2[1]
        return drive - (n2 * t2 + c2 * l2) / f

    return bisect(lambda f: -excess(f), 0.2, 20.0)


def goodman_bray(heights, first_crest, width, a1, a2, dip, phi_deg=None, weight=25e3, tan_phi=None):
    """Columns 1 (toe) to n on a base that steps up towards the crest. first_crest: number of the column at the crest; `dip` of the
    base; a1, a2, as in the source. Returns the force P_0 [N] that has to hold column 1, and which columns topple, slide or stand."""
    t = math.tan(rad(phi_deg)) if tan_phi is None else tan_phi
    s, k = math.sin(rad(dip)), math.cos(rad(dip))
    p, modes = 0.0, {}
    for n in range(len(heights), 0, -1):
        y = heights[n - 1]
        w = weight * y * width
        if n < first_crest:
            m_arm, l_arm = y, y - a1
        elif n == first_crest:
            m_arm, l_arm = y - a2, y - a1
        else:
            m_arm, l_arm = y - a2, y
        if n == 1:
            l_arm = y  # P_0 acts there
        topple = (p * (m_arm - width * t) + 0.5 * w * (y * s - width * k)) / l_arm if l_arm > 0.0 else -math.inf
        slide = p - w * (k * t - s) / (1.0 - t * t)
        p = max(topple, slide, 0.0)
        modes[n] = "stands" if p == 0.0 and max(topple, slide) < 0.0 else ("topples" if topple >= slide else "slides")
    return p, modes


def published_columns():
    """The example of the source: 16 columns, 10 m wide, on a base at 30 degrees with steps of 1 m (b), crest column 10."""
    a1, a2, b = 5.0, 5.2, 1.0
    heights = [n * (a1 - b) for n in range(1, 11)]
    while len(heights) < 16:
        heights.append(heights[-1] - a2 - b)
    return heights, a1, a2, b


def goodman_bray_factor(tan_phi, **geometry):
    """P_0 decreases with friction: the F at which the reduced friction just holds the columns."""
    return bisect(lambda f: 1e-6 - goodman_bray(tan_phi=tan_phi / f, **geometry)[0], tan_phi / 0.999, 10.0)  # the form of the slide needs tan phi < 1


def least_residual(columns, wanted):
    """Least sum |A x - b| over x >= 0, by the simplex method (phase one; Bland's rule, so it ends).
    @param columns  of A, each as {row: value}     @param wanted  b"""
    rows, n = len(wanted), len(columns)
    table = [[0.0] * (n + 1) for _ in range(rows)]
    for j, column in enumerate(columns):
        for i, value in column.items():
            table[i][j] = value if wanted[i] >= 0.0 else -value
    for i, b in enumerate(wanted):
        table[i][n] = abs(b)
    cost = [-sum(table[i][j] for i in range(rows)) for j in range(n + 1)]  # reduced costs of the artificial basis; its sum at the end
    basis = [n + i for i in range(rows)]
    while True:
        enters = next((j for j in range(n) if cost[j] < -1e-10), None)
        if enters is None:
            return -cost[n]
        steps = [(table[i][n] / table[i][enters], basis[i], i) for i in range(rows) if table[i][enters] > 1e-10]
        _, _, leaves = min(steps)
        basis[leaves] = enters
        pivot = table[leaves][enters]
        row = table[leaves] = [v / pivot for v in table[leaves]]
        used = [j for j in range(n + 1) if row[j] != 0.0]
        for other in [table[i] for i in range(rows) if i != leaves] + [cost]:
            factor = other[enters]
            if factor != 0.0:
                for j in used:
                    other[j] -= factor * row[j]


def stands(blocks, contacts, tan_phi):
    """Whether forces within Coulomb's cones at the ends of the contacts hold every block: the static theorem of limit analysis.
    A pressure of any shape on a contact has its resultant between the ends, so two forces stand for all of them.
    @param blocks  (weight along x, weight along y, x, y of the centroid) [N, m]
    @param contacts  (pushed block, other block or None for the ground, x, y, unit normal into the pushed block, edges of the cone n + e tan(phi) t,
    t = n turned to the left: (1, -1), or one of them if the direction of the slip is known)"""
    scale = max(math.hypot(b[0], b[1]) for b in blocks)
    arm = max(max(abs(b[2]), abs(b[3])) for b in blocks)
    columns = []
    for a, b, x, y, nx, ny, edges in contacts:
        for side in edges:
            fx, fy = nx - side * tan_phi * ny, ny + side * tan_phi * nx
            column = {}
            for block, sign in ((a, 1.0), (b, -1.0)):
                if block is not None:
                    cx, cy = blocks[block][2:]
                    column.update({3 * block: sign * fx, 3 * block + 1: sign * fy, 3 * block + 2: sign * ((x - cx) * fy - (y - cy) * fx) / arm})
            columns.append(column)
    wanted = [v for b in blocks for v in (-b[0] / scale, -b[1] / scale, 0.0)]
    return least_residual(columns, wanted) < 1e-7


def columns_factor(tan_phi, heights, width, step, dip, topple=(), weight=25e3):
    """Factor of the columns of `goodman_bray` by `stands`. Axes: u up the base, v out of it; column 1 is at the toe, u = 0.
    A joint that slips without dilation violates the theorem of limit analysis: forces that would hold the columns exist, but their motion does not
    mobilise them. So the motion has to be given: columns that topple rest on their lower corner, lean on the next one at the highest point
    they share, and slip there at Coulomb's limit. Base and joints of all others, and those below the lowest that topples, are free within their cones.
    @param topple  numbers of these columns; none: the bound of the static theorem"""
    s, k, both = math.sin(rad(dip)), math.cos(rad(dip)), (1.0, -1.0)
    blocks, contacts = [], []
    for i, y in enumerate(heights):
        w, u, v = weight * y * width, i * width, i * step
        blocks.append((-w * s, -w * k, u + 0.5 * width, v + 0.5 * y))
        topples = i + 1 in topple
        contacts += [(i, None, p, v, 0.0, 1.0, both) for p in ((u,) if topples else (u, u + width))]
        if i + 1 < len(heights):
            foot, top = v + step, min(v + y, v + step + heights[i + 1])
            if topples:  # its upper side rises along the next column, which pulls it down: t = (0, -1) for the normal (-1, 0)
                contacts.append((i, i + 1, u + width, top, -1.0, 0.0, (1.0,)))
            else:
                contacts += [(i, None, u + width, z, -1.0, 0.0, both) for z in (v, foot)]  # the riser of the next step
                contacts += [(i, i + 1, u + width, z, -1.0, 0.0, both) for z in (foot, top)]
    return bisect(lambda f: 0.5 if stands(blocks, contacts, tan_phi / f) else -0.5, tan_phi / 0.999, 10.0, 1e-5)  # a steeper slip pulls more than it is pressed


def check():
    assert abs(plane_factor(1.0, 30.0, 35.0) - math.tan(rad(35)) / math.tan(rad(30))) < 1e-12
    corners, size, length, _, _ = face_block(30.0, 60.0, 35.0, 0.0, 0.0)
    assert abs(size - 0.5 * 900.0 * (1 / math.tan(rad(35)) - 1 / math.tan(rad(60)))) < 1e-9 and len(corners) == 3
    # Culmann: on the worst plane F = 1 at that height, above 1 on its neighbours
    h, phi, gamma, c, face = culmann_height(20e3, 25.0, 26e3, 70.0), 25.0, 26e3, 20e3, 70.0
    for dip, expected in ((47.5, 0.0), (44.0, 1.0), (51.0, 1.0)):
        _, size, length, _, _ = face_block(h, face, dip, 0.0, 0.0)
        f = plane_factor(gamma * size, dip, phi, length, c)
        assert abs(f - 1.0) < 1e-12 if expected == 0.0 else f > 1.0, (dip, f)
    # two wedges with one dip and no friction between them are one block; with friction between them the joint holds
    assert abs(two_wedge_factor(3.0, 30, 35, 1.0, 30.0 - 1e-9, 35, 0.0) - math.tan(rad(35)) / math.tan(rad(30))) < 1e-6
    smooth, rough = (two_wedge_factor(3e6, 50, 30, 2e6, 10, 30, p) for p in (0.0, 30.0))
    assert rough > smooth
    # by hand, without friction: n12 = w1 tan 50, drive = w1 tan 50 cos 10 + w2 sin 10, n2 = w2 cos 10 - w1 tan 50 sin 10, phi1 = 0
    f = two_wedge_factor(1e6, 50, 0.0, 5e6, 10, 30, 0.0)
    e = 1e6 * math.tan(rad(50))
    n2 = 5e6 * math.cos(rad(10)) - e * math.sin(rad(10))
    assert abs(f - n2 * math.tan(rad(30)) / (e * math.cos(rad(10)) + 5e6 * math.sin(rad(10)))) < 1e-9
    # the published example: tan phi 0.7855 just holds, P_0 = 0.5 kN; the modes of its table
    heights, a1, a2, b = published_columns()
    g = dict(heights=heights, first_crest=10, width=10.0, a1=a1, a2=a2, dip=30.0)
    p0, modes = goodman_bray(tan_phi=0.7855, **g)
    assert p0 < 2e3, p0
    assert [modes[n] for n in (16, 15, 14)] == ["stands"] * 3 and all(modes[n] == "topples" for n in range(4, 14)), modes
    assert all(modes[n] == "slides" for n in (2, 3)), modes  # column 1 as well, with no force on it
    assert abs(goodman_bray_factor(0.7855, **g) - 1.0) < 0.002
    check_stands()
    # the sequence of columns against the linear programme, which assumes no point of application in base and toe, and lets other columns move as well
    for tan_phi in (0.7855, math.tan(rad(43.0))):
        by_sequence, by_programme = goodman_bray_factor(tan_phi, **g), columns_factor(tan_phi, heights, 10.0, b, 30.0, range(4, 14))
        assert abs(by_sequence - by_programme) < 2e-5, (by_sequence, by_programme)
        for topple in (range(3, 13), range(4, 13), range(5, 14)):
            assert columns_factor(tan_phi, heights, 10.0, b, 30.0, topple) > by_programme + 5e-4
    assert columns_factor(0.7855, heights, 10.0, b, 30.0) > 1.15  # joints that may dilate hold the columns against each other


def check_stands():
    """The linear programme for a block on a plane, which slides or topples, and for one that is propped by another."""
    def factor(blocks, contacts, phi):
        return bisect(lambda f: 0.5 if stands(blocks, contacts, math.tan(rad(phi)) / f) else -0.5, 0.5, 10.0, 1e-7)

    s, k, both = math.sin(rad(30.0)), math.cos(rad(30.0)), (1.0, -1.0)
    block = lambda b, h, u=0.0, w=1.0: (-w * s, -w * k, u + 0.5 * b, 0.5 * h)  # weight w on a plane at 30 degrees, u up the plane
    on = lambda i, u, b: [(i, None, p, 0.0, 0.0, 1.0, both) for p in (u, u + b)]
    assert abs(factor([block(1.0, 0.5)], on(0, 0.0, 1.0), 40.0) - math.tan(rad(40.0)) / math.tan(rad(30.0))) < 1e-6
    assert stands([block(1.0, 1.0 / math.tan(rad(30.1)))], on(0, 0.0, 1.0), math.tan(rad(40.0)))  # b/h just above tan 30
    assert not stands([block(1.0, 1.0 / math.tan(rad(29.9)))], on(0, 0.0, 1.0), math.tan(rad(40.0)))
    # a smooth block of weight 0.3 leans on a rough one of weight 1: F = w1 cos tan phi/((w1 + w2) sin)
    smooth = [(1, None, p, 0.0, 0.0, 1.0, (0.0,)) for p in (1.0, 2.0)] + [(0, 1, 1.0, p, -1.0, 0.0, (0.0,)) for p in (0.0, 0.5)]
    pair = factor([block(1.0, 0.5), block(1.0, 0.5, 1.0, 0.3)], on(0, 0.0, 1.0) + smooth, 40.0)
    assert abs(pair - math.tan(rad(40.0)) / math.tan(rad(30.0)) / 1.3) < 1e-6, pair


if __name__ == "__main__":
    check()
    heights, a1, a2, b = published_columns()
    g = dict(heights=heights, first_crest=10, width=10.0, a1=a1, a2=a2, dip=30.0)
    print("published columns: P_0 at tan phi 0.7855: %.4g kN; F of tan phi 0.95: %.4f" % (goodman_bray(tan_phi=0.7855, **g)[0] / 1e3, goodman_bray_factor(0.95, **g)))
    for phi in (38.15, 43.0):
        t = math.tan(rad(phi))
        print("F of the published columns, phi %.2f: by the sequence %.5f, by the linear programme %.5f, bound of the static theorem %.4f" % (
            phi, goodman_bray_factor(t, **g), columns_factor(t, heights, 10.0, b, 30.0, range(4, 14)), columns_factor(t, heights, 10.0, b, 30.0)))
    print("all closed forms agree with each other")
