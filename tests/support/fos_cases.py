"""Case files of slopes whose factor of safety is known (limit_analysis.py), written as TOML texts."""

import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import limit_analysis as la  # noqa: E402

DENSITY, GRAVITY = 2600.0, 9.81


def ring(corners):
    return "[" + ", ".join("[%.10g, %.10g]" % tuple(c) for c in corners) + "]"


def case(title, base, blocks, joints, method="dda", integrator="implicit", cover=None, young="50 GPa", extra="", dt="5 ms"):
    """@param base  corners of the held block     @param blocks  (name, corners) of free blocks     @param joints  name: keys of the law; the first
    is the default"""
    lines = ['title = "%s"' % title, "[model]", 'default_joint = "%s"' % next(iter(joints))]
    if cover:
        lines.append("cover_size = %g" % cover)
    lines += ["[material.rock]", "density = %g" % DENSITY, 'young = "%s"' % young, "poisson = 0.2"]
    for name, keys in joints.items():
        lines += ["[joint.%s]" % name] + ["%s = %s" % (k, v if isinstance(v, str) else "%.10g" % v) for k, v in keys.items() if k != "edges"]
    for name, corners, *law in [("base", base)] + list(blocks):
        lines += ["[[block]]", 'name = "%s"' % name, "polygon = " + ring(corners), 'material = "rock"']
        if law:
            lines.append('joint = "%s"' % law[0])
    lines += ["[[support]]", 'block = "base"']
    lines += ["[[stage]]", 'name = "rest"', 'method = "%s"' % method, 'integrator = "%s"' % integrator, "rest = true", "duration = 40.0", "rest_force = 1e-6"]
    if integrator == "implicit":
        lines += ['dt = "%s"' % dt, "rest_steps = 4000"]
    return "\n".join(lines) + "\n" + extra


def plane_slope(height=20.0, face=60.0, dip=35.0, phi=40.0, c=0.0, crack=0.0, water=0.0, **how):
    """A face whose plane leaves at the toe; it slides towards -x. @return case, factor"""
    corners, size, length, uplift, thrust = la.face_block(height, face, dip, crack, water)
    f = la.plane_factor(DENSITY * GRAVITY * size, dip, phi, length, c, uplift, thrust)
    x, t = corners[1][0], math.tan(la.rad(dip))
    base = [(-15.0, -15.0 * t - 5.0), (x + 15.0, -15.0 * t - 5.0), (x + 15.0, height), (x, height), (x, height - crack), (-15.0, -15.0 * t)]
    if crack == 0.0:
        base = [p for i, p in enumerate(base) if i != 4]
    law = {"friction_deg": phi, "cohesion": c}
    law.update(how.pop("law", {}))
    extra = "" if water == 0.0 else "[[water]]\nline = [[0, 0], [%.10g, %.10g]]\n" % (x, height - crack + water)
    return case("plane failure", base, [("wedge", corners)], {"plane": law}, extra=extra, **how), f


def anchored_plane(phi=30.0, dip=35.0, pull=1e6, active=True, **how):
    """A plane that needs its anchor, which crosses it at 50 degrees: one that is stretched to `pull` [N] and yields to no more, or a bar without
    pretension that yields at it. A bar's capacity is not divided by F. @return case, factor, factor where the capacity is divided too"""
    text, _ = plane_slope(phi=phi, dip=dip, **how)
    x, y, angle, reach = 9.0, 9.0 * math.tan(la.rad(60.0)), dip - 50.0, 22.0
    toe = (x + reach * math.cos(la.rad(angle)), y + reach * math.sin(la.rad(angle)))
    # stiffness (pull per slip): small for the anchor, so that it keeps its pull; large for the bar, so that it yields before the slope has moved by the limit
    stiff = 2e8 if active else 8e9
    text += '[[bolt]]\nname = "anchor"\nhead = [%.10g, %.10g]\ntoe = [%.10g, %.10g]\naxial_stiffness = %g\n' % (x, y, toe[0], toe[1], stiff)
    text += ("pretension = %g\n" % pull if active else "") + "yield = %.10g\n" % (pull * 1.000001)
    weight = DENSITY * GRAVITY * la.face_block(20.0, 60.0, dip, 0.0, 0.0)[1]
    s, k, t = math.sin(la.rad(dip)), math.cos(la.rad(dip)), math.tan(la.rad(phi))
    across, along = pull * math.sin(la.rad(50.0)), pull * math.cos(la.rad(50.0))
    return text, (weight * k + across) * t / (weight * s - along), ((weight * k + across) * t + along) / (weight * s)


def block_on_plane(width, height, dip, phi, c=0.0, **how):
    """A rectangle on a plane; it slides towards -x. @return case, factor"""
    s, k = math.sin(la.rad(dip)), math.cos(la.rad(dip))
    at = lambda a, b: (a * k - b * s, a * s + b * k)  # up the plane, out of it
    base = [at(-3 * width, -2.0 * height), at(4 * width, -2.0 * height), at(4 * width, 0.0), at(-3 * width, 0.0)]
    block = [at(0, 0), at(width, 0), at(width, height), at(0, height)]
    law = {"friction_deg": phi, "cohesion": c}
    law.update(how.pop("law", {}))
    f = la.plane_factor(DENSITY * GRAVITY * width * height, dip, phi, width, c) if dip > 0.0 else math.inf
    return case("block on a plane", base, [("block", block)], {"plane": law}, **how), f


def excavated_toe(dip=30.0, phi=45.0, width=4.0, height=2.0):
    """A block on a plane against a held toe, which a stage to rest excavates. @return case, factor"""
    s, k = math.sin(la.rad(dip)), math.cos(la.rad(dip))
    at = lambda a, b: (a * k - b * s, a * s + b * k)  # up the plane, out of it
    base = [at(-width, -2.0), at(2 * width, -2.0), at(2 * width, 0.0), at(-width, 0.0)]
    block = [at(0, 0), at(width, 0), at(width, height), at(0, height)]
    toe = [at(-2, 0), at(0, 0), at(0, height), at(-2, height)]
    extra = "\n".join(["[[support]]", 'block = "toe"', "[[stage]]", 'name = "toe"', 'method = "dda"', 'integrator = "implicit"', 'dt = "5 ms"', "rest = true", "duration = 40.0",
                       "rest_force = 1e-6", 'excavate = ["toe"]', "release_time = 0.1"])
    return (case("the toe of a block on a plane is excavated", base, [("block", block), ("toe", toe)], {"plane": {"friction_deg": phi}}, extra=extra + "\n"),
            la.plane_factor(DENSITY * GRAVITY * width * height, dip, phi, width, 0.0))


def two_wedges(phi=30.0, between=25.0, c=0.0, dip1=50.0, dip2=10.0, **how):
    """The upper block has its tip cut off: it moves at dip1, and the tip would run into the lower plane. @return case, factor"""
    t1, t2 = math.tan(la.rad(dip1)), math.tan(la.rad(dip2))
    x2, h, run = 14.0, 7.0, 6.0
    joint = [(x2, x2 * t2), (x2, x2 * t2 + h)]
    top = (x2 + run, x2 * t2 + run * t1)
    lower = [(0.0, 0.0), joint[0], joint[1], (0.0, 4.0)]
    tip = 0.4
    upper = [(x2 + tip, x2 * t2 + tip * t1), top, joint[1], (x2, x2 * t2 + 2.0 * tip)]
    base = [(-15.0, -15.0 * t2 - 6.0), (top[0] + 12.0, -15.0 * t2 - 6.0), (top[0] + 12.0, top[1] + 12.0 * t1), joint[0], (-15.0, -15.0 * t2)]
    w = DENSITY * GRAVITY
    f = la.two_wedge_factor(w * la.area(upper), dip1, phi, w * la.area(lower), dip2, phi, between, l1=(run - tip) / math.cos(la.rad(dip1)), c1=c,
                            l2=x2 / math.cos(la.rad(dip2)), c2=c)
    joints = {"plane": {"friction_deg": phi, "cohesion": c}, "between": {"friction_deg": between}}
    text = case("two wedges", base, [("lower", lower), ("upper", upper)], joints, **how)
    # the edges from joint[0] to joint[1] have the law of the joint between the blocks
    text = text.replace('name = "lower"', 'name = "lower"\nedge_joints = ["plane", "between", "plane", "plane"]')
    text = text.replace('name = "upper"', 'name = "upper"\nedge_joints = ["plane", "plane", "between", "plane"]')
    return text, f


def columns(heights, width, a1, a2, b, dip, phi, first_crest, **how):
    """Goodman and Bray's columns on a stepped base; they topple towards -x. @return case, factor"""
    s, k = math.sin(la.rad(dip)), math.cos(la.rad(dip))
    at = lambda u, v: (u * k - v * s, u * s + v * k)  # up the base, out of it
    n = len(heights)
    deep = -3.0 * width
    path = [(-2.0 * width, -b)]
    for i in range(n):
        path += [(i * width, (i - 1) * b), (i * width, i * b)]
    path += [(n * width, (n - 1) * b), ((n + 1) * width, (n - 1) * b)]
    base = [at(*p) for p in [(-2.0 * width, deep), ((n + 1) * width, deep)] + path[::-1]]
    blocks = []
    for i, y in enumerate(heights):
        u0, u1, v = i * width, (i + 1) * width, i * b
        blocks.append(("column-%d" % (i + 1), [at(u0, v), at(u1, v), at(u1, v + y), at(u0, v + y)]))
    f = la.goodman_bray_factor(math.tan(la.rad(phi)), heights=heights, first_crest=first_crest, width=width, a1=a1, a2=a2, dip=dip, weight=DENSITY * GRAVITY)
    return case("columns", base, blocks, {"layer": {"friction_deg": phi}}, **how), f


def published_columns(phi=43.0, **how):
    heights, a1, a2, b = la.published_columns()
    return columns(heights, 10.0, a1, a2, b, 30.0, phi, 10, **how)


def hanging_block(tension=80e3, cohesion=400e3, height=2.0, **how):
    """A block that hangs from a roof by its tensile strength. @return case, factor"""
    base = [(-4.0, 0.0), (4.0, 0.0), (4.0, 3.0), (-4.0, 3.0)]
    block = [(-1.0, -height), (1.0, -height), (1.0, 0.0), (-1.0, 0.0)]
    law = {"friction_deg": 30.0, "cohesion": cohesion, "tensile_strength": tension}
    return case("block under a roof", base, [("block", block)], {"bond": law}, **how), tension / (DENSITY * GRAVITY * height)
