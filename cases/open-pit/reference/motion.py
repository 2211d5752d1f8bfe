"""The ground motion of the case open-pit: a synthetic record of 10 s, peak 0.2 g, printed as shaking.csv.

Ten sines under an envelope that rises in 2 s, stays and dies away from 7 s on; phases from a Lehmer generator with seed
652.
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "tools"))
from synthetic_record import scaled, sines  # noqa: E402

PEAK, STEP, DURATION = 0.2, 0.01, 10.0
FREQUENCIES = (0.6, 0.9, 1.3, 1.8, 2.4, 3.1, 3.9, 4.8, 5.9, 7.2)


def envelope(t):
    return min(1.0, t / 2.0) * (math.exp(-0.7 * (t - 7.0)) if t > 7.0 else 1.0) * min(1.0, (DURATION - t) / 2.0)


if __name__ == "__main__":
    print("# Synthetic record, peak 0.2 g, by reference/motion.py.")
    print("time [s], acceleration [g]")
    for i, x in enumerate(scaled(sines(FREQUENCIES, 652, STEP, DURATION, envelope), PEAK)):
        print(f"{i * STEP:.2f}, {x:.6f}")
