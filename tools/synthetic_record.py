"""Synthetic ground motions of the case library: sines under an envelope, their phases from a generator of Lehmer's."""
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
    """The same with this largest magnitude, to six decimals."""
    largest = max(map(abs, samples))
    return [round(peak * x / largest, 6) + 0.0 for x in samples]
