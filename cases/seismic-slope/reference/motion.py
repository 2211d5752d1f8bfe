"""The ground motion of the case seismic-slope: a synthetic record of 20 s, peak 0.3 g, printed as shaking.csv.

Ten sines under an envelope that rises in 4 s, stays and dies away from 12 s on; phases from a Lehmer generator with
seed 2013.
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "tools"))
from synthetic_record import scaled, sines  # noqa: E402

PEAK, STEP, DURATION = 0.3, 0.01, 20.0
FREQUENCIES = (0.6, 0.9, 1.3, 1.8, 2.4, 3.1, 3.9, 4.8, 5.9, 7.2)


def envelope(t):
    return min(1.0, t / 4.0) * (math.exp(-0.35 * (t - 12.0)) if t > 12.0 else 1.0) * min(1.0, (DURATION - t) / 2.0)


if __name__ == "__main__":
    print("# Synthetic record, peak 0.3 g, by reference/motion.py.")
    print("time [s], acceleration [g]")
    for i, x in enumerate(scaled(sines(FREQUENCIES, 2013, STEP, DURATION, envelope), PEAK)):
        print(f"{i * STEP:.2f}, {x:.6f}")
