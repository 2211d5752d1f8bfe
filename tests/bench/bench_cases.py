"""Cases of the bench: walls of blocks in running bond, a block with a mesh, two blocks, a stiff stack."""
import math

SETTLED = 0.4  # [s]: static steps of 20 ms; measurements begin afterwards
STATIC_STEPS = 20

HEAD = """
title = "bench"
material.rock = {{ density = 2500.0, young = "{young} GPa", poisson = 0.2 }}
joint.joint = {{ friction_deg = 31.0 }}
model = {{ default_joint = "joint" }}
"""

TWO_BLOCKS = """
title = "Block on a plane"
material.rock = { density = 2600.0, young = "1 GPa", poisson = 0.2 }
joint.plane = { friction_deg = 20.0 }
support = [{ block = "plane" }]
block = [
  { name = "plane", material = "rock", polygon = [[-4, -12], [20, -12], [-4, 2]] },
  { name = "slider", material = "rock", polygon = [[0, -0.333333333], [1, -0.916666667], [1.6, 0.1], [0.6, 0.7]] },
]
stage = [{ name = "slide", method = "dda", integrator = "implicit", dt = "1 ms", duration = 1.0 }]
"""


# The middle one of three stiff blocks takes implicit steps of 1 ms, those below and above it explicit ones.
STIFF_STACK = """
title = "Stiff stack"
material.rock = { density = 2600.0, young = "50 GPa", poisson = 0.2 }
joint.stiff = { friction_deg = 40.0, normal_stiffness = 5e11 }
model = { default_joint = "stiff", cover_size = 0.5 }
support = [{ block = "base" }]
block = [
  { name = "base", material = "rock", polygon = [[-1, -1], [4, -1], [4, 0], [-1, 0]] },
  { name = "low", material = "rock", polygon = [[0, 0], [3, 0], [3, 1], [0, 1]] },
  { name = "middle", material = "rock", polygon = [[0, 1], [3, 1], [3, 2], [0, 2]] },
  { name = "high", material = "rock", polygon = [[0, 2], [3, 2], [3, 3], [0, 3]] },
]
stage = [{ name = "stand", method = "nmm", integrator = "partitioned", dt = "1 ms", duration = 0.16, explicit_blocks = ["low", "high"] }]
"""


def wall_blocks(courses):
    """30 courses are 915 blocks, 100 are 10,050 and 316 are 100,014."""
    return sum(courses + 1 if j % 2 == 0 else courses for j in range(courses))


def settled(courses):
    """Time [s] after which a wall is measured: so many static steps, each in proportion to its height.

    A wall of twice the height vibrates at half the frequency: after static steps of the same length it would be farther from rest.
    """
    return SETTLED * max(1.0, courses / 30)


def shaking():
    """The record of the shaken walls, shaking.csv."""
    return "".join(f"{1e-3 * i:.3f}, {4.0 * math.sin(4.0 * math.pi * 1e-3 * i):.17g}\n" for i in range(2001))


def wall(courses, integrator, shaken=False, apart=False, settle=True):
    """Courses of n + 1 and n blocks of 1 x 0.5 m in turn on a base that is held or shaken (2 Hz, 4 m/s2, horizontally).

    apart: the same blocks a quarter of their width from each other, so that nothing touches.
    settle: static steps first.
    """
    pitch, rise = (1.25, 0.625) if apart else (1.0, 0.5)
    lines = [HEAD.format(young=5)]
    if shaken:
        lines.append(f'motion.shaking = {{ file = "shaking.csv", unit = "m/s2", start = {settled(courses)} }}\n')
    lines.append('support = [{ block = "base"' + (', motion = "shaking"' if shaken else "") + " }]\n")
    blocks = [("base", [(-3.0, -2.0), (pitch * courses + 4.0, -2.0), (pitch * courses + 4.0, 0.0), (-3.0, 0.0)])]
    lift = 0.125 if apart else 0.0
    for j in range(courses):
        for i in range(courses + 1 if j % 2 == 0 else courses):
            x, y = pitch * (i + (0.0 if j % 2 == 0 else 0.5)), rise * j + lift
            blocks.append((f"b{j}-{i}", [(x, y), (x + 1.0, y), (x + 1.0, y + 0.5), (x, y + 0.5)]))
    for name, ring in blocks:
        lines.append(f'[[block]]\nname = "{name}"\nmaterial = "rock"\npolygon = {[list(p) for p in ring]}\n')
    if settle:
        lines.append(f'[[stage]]\nname = "settle"\nmethod = "dda"\nintegrator = "implicit"\ndt = {settled(courses) / STATIC_STEPS}\nduration = {settled(courses)}\nrest = true\n')
    dt = "\"auto\"" if integrator == "explicit" else "0.001"
    lines.append(f'[[stage]]\nname = "steps"\nmethod = "dda"\nintegrator = "{integrator}"\ndt = {dt}\nduration = 1.0\n')
    lines.append("[output]\nevery = 10.0\nhistory_every = 10.0\n")
    return "".join(lines)


def piles(integrator, sleep, piles=20):
    """Piles of 52 blocks of 1 x 0.5 m on a held base; those of the first are accelerated to and fro (2 Hz, 4 m/s2)."""
    lines = [HEAD.format(young=5), 'support = [{ block = "base" }]\n',
             f'function.shake = {{ shape = "sine", frequency = 2.0, start = {SETTLED}, duration = 100.0 }}\n']
    blocks = [("base", [(-5.0, -2.0), (15.0 * piles, -2.0), (15.0 * piles, 0.0), (-5.0, 0.0)])]
    for p in range(piles):
        for j in range(8):
            for i in range(10 - j):
                x, y = 15.0 * p + i + 0.5 * j, 0.5 * j
                blocks.append((f"p{p}-{j}-{i}", [(x, y), (x + 1.0, y), (x + 1.0, y + 0.5), (x, y + 0.5)]))
    for name, ring in blocks:
        lines.append(f'[[block]]\nname = "{name}"\nmaterial = "rock"\npolygon = {[list(p) for p in ring]}\n')
    lines.append('[[body_acceleration]]\nblocks = ["p0-*"]\nacceleration = [4.0, 0.0]\nfunction = "shake"\n')
    lines.append(f'[[stage]]\nname = "settle"\nmethod = "dda"\nintegrator = "implicit"\ndt = 0.02\nduration = {SETTLED}\nrest = true\n')
    dt = "\"auto\"" if integrator == "explicit" else "0.001"
    lines.append(f'[[stage]]\nname = "steps"\nmethod = "dda"\nintegrator = "{integrator}"\ndt = {dt}\nduration = 1.0\nsleep = {sleep}\n')
    lines.append("[output]\nevery = 10.0\nhistory_every = 10.0\n")
    return "".join(lines)


def mesh(cover):
    """A held block and one with a mesh on it."""
    return HEAD.format(young=5) + f"""
support = [{{ block = "base" }}]
block = [
  {{ name = "base", material = "rock", polygon = [[-1, -1], [9, -1], [9, 0], [-1, 0]] }},
  {{ name = "block", material = "rock", polygon = [[0, 0], [8, 0], [8, 8], [0, 8]], cover_size = {cover} }},
]
stage = [{{ name = "steps", method = "nmm", method_of = [{{ blocks = ["base"], method = "dda" }}], integrator = "explicit", dt = "auto", duration = 0.01 }}]
"""
