"""Toppling or sliding of a block on a plane: the four dynamic regimes, by runs. Width over height d, slope a, friction
phi:

    stands | slides         phi = a                (d above tan a)
    stands | topples        d = tan a              (phi large)
    slides | both           d = tan phi            (phi below a)
    topples | both          tan phi = [3d + (1 + 4d^2) tan a]/[3d tan a + 4 + d^2]

The last two are where dynamics puts them, not statics: a block that slides is pushed less, and one that turns about its toe presses less on it. A run half a degree on
either side of a border must show the regime of that side.

usage: topple_chart.py SCREE quick|full [WORK]
"""

import csv
import math
import os
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "support"))
import fos_cases  # noqa: E402

SCREE = os.path.abspath(sys.argv[1])
HEIGHT = 2.0  # of the block [m]
TIME = 0.4  # of a run [s]
SMALL = 2e-4  # slip [m] and turn times width [m]: half a degree causes ten times as much in that time, elastic settling a hundredth of it
EARLY = 5e-3  # the regime is that of the beginning, since a slender block that has turned far finally slides [m]
PART = 0.02  # fraction of the larger of the two above which the smaller one counts; half a degree causes 0.05 and more


def critical_phi(d, a):
    """Friction [deg] below which a block that topples slides too."""
    t = math.tan(math.radians(a))
    return math.degrees(math.atan((3 * d + (1 + 4 * d * d) * t) / (3 * d * t + 4 + d * d)))


def regime(d, a, phi):
    topples, slides = d < math.tan(math.radians(a)), phi < a
    if topples and phi >= critical_phi(d, a):
        return "topples"
    if slides and d >= math.tan(math.radians(phi)):
        return "slides"
    return "both" if topples or slides else "stands"


def run(work, d, a, phi, method="dda"):
    """Motion of a block from rest, in TIME."""
    width = d * HEIGHT
    text, _ = fos_cases.block_on_plane(width, HEIGHT, a, phi, young="50 GPa")
    text = text[: text.index("[[stage]]")]
    s, k = math.sin(math.radians(a)), math.cos(math.radians(a))
    text += '[[monitor]]\nname = "toe"\nblock = "block"\npoint = [0, 0]\n'
    text += '[[monitor]]\nname = "heel"\nblock = "block"\npoint = [%.10g, %.10g]\n' % (width * k, width * s)
    text += '[[stage]]\nname = "go"\nmethod = "%s"\nintegrator = "implicit"\ndt = "1 ms"\nduration = %g\n[output]\nevery = %g\nhistory_every = "4 ms"\n' % (method, TIME, TIME)
    name = "%s-%g-%g-%g" % (method, d, a, phi)
    path = os.path.join(work, name + ".toml")
    with open(path, "w") as f:
        f.write(text)
    out = os.path.join(work, name)
    subprocess.run([SCREE, "run", path, "--out", out, "--quiet", "--threads", "1"], check=True, capture_output=True)
    with open(os.path.join(out, "history.csv")) as f:
        rows = list(csv.reader(line for line in f if not line.startswith("#")))
    head = [h.split(" ")[0] for h in rows[0]]
    for row in rows[1:]:
        at = dict(zip(head, row))
        toe, heel = ((float(at[m + ".ux"]), float(at[m + ".uy"])) for m in ("toe", "heel"))
        slip = abs(toe[0] * k + toe[1] * s)
        turn = abs((heel[1] - toe[1]) * k - (heel[0] - toe[0]) * s)
        if max(slip, turn) >= EARLY:
            break
    shutil.rmtree(out)
    least = max(SMALL, PART * max(slip, turn))
    does_slide, does_topple = slip > least, turn > least
    return ("both" if does_topple else "slides") if does_slide else ("topples" if does_topple else "stands"), slip, turn


def near_borders(slopes, half=0.5):
    """Points on either side of each border."""
    tan = lambda x: math.tan(math.radians(x))
    for a in slopes:
        for sign in (-half, half):
            yield 1.5 * tan(a), a, a + sign  # stands | slides
            yield tan(a + sign), a, 60.0  # stands | topples
            yield tan(0.6 * a + sign), a, 0.6 * a  # slides | both
            yield 0.5 * tan(a), a, critical_phi(0.5 * tan(a), a) + sign  # topples | both


def grid():
    for a in range(10, 50, 5):
        for d10 in range(1, 16, 2):
            for phi in range(5, 55, 5):
                d = d10 / 10.0
                border = min(abs(phi - a), abs(math.degrees(math.atan(d)) - a), abs(math.degrees(math.atan(d)) - phi), abs(phi - critical_phi(d, a)))
                if border > 0.5:
                    yield d, float(a), float(phi)


def main():
    work = sys.argv[3] if len(sys.argv) > 3 else tempfile.mkdtemp(prefix="scree-topple-")
    assert abs(critical_phi(0.3, 30.0) - 20.1) < 0.05
    os.makedirs(work, exist_ok=True)
    points = list(near_borders([30.0])) if sys.argv[2] == "quick" else list(near_borders([15.0, 20.0, 30.0, 40.0])) + list(grid())
    wrong = 0
    with ThreadPoolExecutor(2) as pool:
        for (d, a, phi), (found, slip, turn) in zip(points, pool.map(lambda p: run(work, *p), points)):
            wanted = regime(d, a, phi)
            if found != wanted or sys.argv[2] == "quick":
                print("%-4s d %.4f a %g phi %.3f: %s, wanted %s (slip %.2g m, turn %.2g m)" % ("ok" if found == wanted else "FAIL", d, a, phi, found, wanted, slip, turn))
            wrong += found != wanted
    print("%d of %d points wrong" % (wrong, len(points)))
    if len(sys.argv) <= 3:
        shutil.rmtree(work)
    sys.exit(wrong > 0)


main()
