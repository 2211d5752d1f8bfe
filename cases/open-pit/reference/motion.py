"""The ground motion of the case open-pit: a synthetic record of 10 s, peak 0.2 g, printed as shaking.csv.

Ten sines under an envelope that rises in 2 s, stays and dies away from 7 s on; the phases from a generator of Lehmer's with seed 652.
"""
import math

PEAK, STEP, DURATION = 0.2, 0.01, 10.0
FREQUENCIES = (0.6, 0.9, 1.3, 1.8, 2.4, 3.1, 3.9, 4.8, 5.9, 7.2)


def samples():
    seed, phases = 652, []
    for _ in FREQUENCIES:
        for _ in range(10):
            seed = seed * 48271 % 2147483647
        phases.append(2.0 * math.pi * seed / 2147483647)
    out = []
    for i in range(round(DURATION / STEP) + 1):
        t = i * STEP
        envelope = min(1.0, t / 2.0) * (math.exp(-0.7 * (t - 7.0)) if t > 7.0 else 1.0) * min(1.0, (DURATION - t) / 2.0)
        out.append(envelope * sum(math.sin(2.0 * math.pi * f * t + p) / math.sqrt(f) for f, p in zip(FREQUENCIES, phases)))
    peak = max(map(abs, out))
    return [round(PEAK * x / peak, 6) + 0.0 for x in out]


if __name__ == "__main__":
    print("# Synthetic record, peak 0.2 g, by reference/motion.py.")
    print("time [s], acceleration [g]")
    for i, x in enumerate(samples()):
        print(f"{i * STEP:.2f}, {x:.6f}")
