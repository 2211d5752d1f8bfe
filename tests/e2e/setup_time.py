#!/usr/bin/python3
"""Growth of the setup time of a model: `scree check` of n, 2n and 4n parallel lines, blocks between crossing lines,
cracks and vertices, by processor time.

Usage: setup_time.py SCREE [--most EXPONENT]

Prints seconds and exponents, and fails where an exponent from n to 4n exceeds `--most` (1.3; 1.6 in a build's tests:
processor times on a busy machine vary). The time of a case with two lines is subtracted. Measured exponents: 0.9 to
1.25.
"""
import argparse
import math
import pathlib
import random
import resource
import subprocess
import sys
import tempfile

HEAD = """[material.rock]
density = 2600.0
young = 1.0e9
poisson = 0.2
[joint.plane]
friction_deg = 30.0
"""
DOMAIN = '[domain]\noutline = [[0, 0], [1000, 0], [1000, 600], [0, 600]]\nmaterial = "rock"\njoint = "plane"\n'
STAGE = '[[stage]]\nname = "run"\nmethod = "{}"\nintegrator = "explicit"\ndt = "auto"\nduration = 0.01\n{}\n[output]\nevery = 0.005\n'
FIRST = {"parallel lines": 1200, "crossing lines": 8000, "cracks": 400, "vertices": 20000}


def lines_at(dip, spacing):
    return f'[[domain.joint_set]]\njoint = "plane"\ndip_deg = {dip}\nspacing = {spacing}\n'


def case(kind, n):
    if kind == "parallel lines":
        return HEAD + DOMAIN + lines_at(30, 1000 / n) + STAGE.format("dda", "")
    if kind == "crossing lines":  # n blocks
        return HEAD + DOMAIN + "".join(lines_at(dip, 900 / math.sqrt(n)) for dip in (30, 110)) + STAGE.format("dda", "")
    if kind == "cracks":
        random.seed(1)
        side = math.ceil(math.sqrt(n))
        text = HEAD + DOMAIN
        for i in range(n):
            x, y, turn = 1000 * (i % side + 0.5) / side, 600 * (i // side + 0.5) / side, random.uniform(0, math.pi)
            dx, dy = 210 / side * math.cos(turn), 210 / side * math.sin(turn)
            text += f'[[domain.trace]]\njoint = "plane"\npoints = [[{x - dx}, {y - dy}], [{x + dx}, {y + dy}]]\n'
        return text + STAGE.format("nmm", f"cover_size = {600 / side}")
    corners = ", ".join(f"[{100 * math.cos(2 * math.pi * i / n):.12g}, {100 * math.sin(2 * math.pi * i / n):.12g}]" for i in range(n))
    return HEAD + f'[[block]]\nname = "b"\nmaterial = "rock"\npolygon = [{corners}]\n' + STAGE.format("dda", "")


def seconds(scree, text, work):
    file = work / "case.toml"
    file.write_text(text)
    best = math.inf
    for _ in range(3):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run([scree, "check", file], check=True, stdout=subprocess.DEVNULL)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        best = min(best, after.ru_utime - before.ru_utime)
    return best


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("scree")
    parser.add_argument("--most", type=float, default=1.3)
    options = parser.parse_args()
    wrong = False
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        idle = seconds(options.scree, case("parallel lines", 2), work)
        for kind, n in FIRST.items():
            times = [max(seconds(options.scree, case(kind, m * n), work) - idle, 1e-3) for m in (1, 2, 4)]
            exponent = math.log(times[2] / times[0]) / math.log(4)
            wrong = wrong or exponent > options.most
            print(f"{kind:15} n = {n:5}: {times[0]:.2f}, {times[1]:.2f}, {times[2]:.2f} s for n, 2n, 4n; exponent {exponent:.2f}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
