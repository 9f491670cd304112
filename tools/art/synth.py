# Builds short sounds from decaying tones and filtered noise, and writes them as WAV files.
# Invariant: a sound is a list of samples, -1..1, at RATE; noise comes from a seed, so equal calls give equal files.
# Source: modal synthesis (a struck thing is a sum of decaying sines: Adrien 1991; van den Doel 2001); plucked string
# of Karplus and Strong 1983; two-pole resonator in its usual form.
import math
import random
import struct

RATE = 22050


def seconds(n):
    return [0.0] * int(n * RATE)


def add(target, source, at_s=0.0, gain=1.0):
    """Mixes source into target, which grows as needed."""
    start = int(at_s * RATE)
    if len(target) < start + len(source):
        target.extend([0.0] * (start + len(source) - len(target)))
    for i, value in enumerate(source):
        target[start + i] += gain * value
    return target


def tone(duration_s, hz, decay_s, hz_end=None, attack_s=0.001, vibrato=0.0):
    """A decaying sine whose pitch may glide; decay_s is the time to 1/e."""
    samples, phase, n = [], 0.0, int(duration_s * RATE)
    hz_end = hz if hz_end is None else hz_end
    for i in range(n):
        t = i / RATE
        pitch = hz * (hz_end / hz) ** (i / n) * (1 + vibrato * math.sin(2 * math.pi * 6 * t))
        phase += 2 * math.pi * pitch / RATE
        samples.append(math.sin(phase) * math.exp(-t / decay_s) * min(1.0, t / attack_s))
    return samples


def modes(duration_s, partials):
    """A struck thing: partials are (Hz, strength, decay in s)."""
    result = seconds(duration_s)
    for hz, strength, decay_s in partials:
        add(result, tone(duration_s, hz, decay_s), gain=strength)
    return result


def noise(duration_s, decay_s, seed, attack_s=0.0005):
    source = random.Random(seed)
    return [
        (2 * source.random() - 1) * math.exp(-i / RATE / decay_s) * min(1.0, i / RATE / attack_s)
        for i in range(int(duration_s * RATE))
    ]


def resonate(samples, hz, width_hz, hz_end=None):
    """Lets through what is near a frequency, which may glide."""
    result, y1, y2, n = [], 0.0, 0.0, len(samples)
    hz_end = hz if hz_end is None else hz_end
    r = math.exp(-math.pi * width_hz / RATE)
    for i, x in enumerate(samples):
        w = 2 * math.pi * (hz * (hz_end / hz) ** (i / n)) / RATE
        y = (1 - r) * x + 2 * r * math.cos(w) * y1 - r * r * y2
        y1, y2 = y, y1
        result.append(y)
    return result


def pluck(duration_s, hz, seed, softness=0.5, damping=0.996):
    source = random.Random(seed)
    line = [2 * source.random() - 1 for _ in range(int(RATE / hz))]
    result = []
    for i in range(int(duration_s * RATE)):
        k = i % len(line)
        following = line[(k + 1) % len(line)]
        result.append(line[k])
        line[k] = damping * ((1 - softness) * line[k] + softness * following)
    return result


def marimba(hz, duration_s=0.9):
    """A warm wooden bar: the tuned fourth harmonic and a short click over the ground tone."""
    return modes(duration_s, [(hz, 1.0, 0.26), (hz * 3.93, 0.30, 0.08), (hz * 9.6, 0.10, 0.03)])


def wav(samples, peak=0.8):
    """16-bit mono WAV bytes, scaled to the peak, with a 6 ms fade at the end against a click."""
    top = max(abs(v) for v in samples) or 1.0
    fade = int(0.006 * RATE)
    n = len(samples)
    data = b"".join(
        struct.pack("<h", round(32767 * peak / top * v * min(1.0, (n - i) / fade))) for i, v in enumerate(samples)
    )
    header = struct.pack("<4sI4s4sIHHIIHH4sI", b"RIFF", 36 + len(data), b"WAVE", b"fmt ", 16, 1, 1, RATE,
                         RATE * 2, 2, 16, b"data", len(data))
    return header + data
