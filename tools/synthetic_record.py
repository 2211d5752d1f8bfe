"""Synthetic ground motions of the case library: sines under an envelope, with phases from a Lehmer generator."""
import math


def sines(frequencies, seed, step, duration, envelope):
    """Samples: sum of sin(2 pi f t + phase)/sqrt(f), times envelope(t).

    frequencies [Hz]; seed: whole, 1 to 2147483646; step, duration [s].
    """
    phases = []
    for _ in frequencies:
        for _ in range(10):
            seed = seed * 48271 % 2147483647
        phases.append(2.0 * math.pi * seed / 2147483647)
    times = [i * step for i in range(round(duration / step) + 1)]
    return [envelope(t) * sum(math.sin(2.0 * math.pi * f * t + p) / math.sqrt(f) for f, p in zip(frequencies, phases)) for t in times]


def scaled(samples, peak):
    """The samples scaled to this largest magnitude, rounded to six decimals."""
    largest = max(map(abs, samples))
    return [round(peak * x / largest, 6) + 0.0 for x in samples]
