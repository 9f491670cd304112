# The sounds of the games below games/examples, by game and name.
import math

from synth import RATE, add, marimba, modes, noise, resonate, tone, wav


def engine():
    """One second that joins its own beginning: every partial has whole periods."""
    samples = []
    for i in range(RATE):
        t = 2 * math.pi * i / RATE
        value = sum(math.sin(hz * t + hz) / (1 + n) for n, hz in enumerate((55, 110, 165, 220, 330)))
        samples.append(value * (1 + 0.3 * math.sin(27 * t)))
    return wav(samples, 0.5)


def bump():
    body = modes(0.25, [(92, 1.0, 0.06), (141, 0.6, 0.04), (377, 0.25, 0.02)])
    return wav(add(body, resonate(noise(0.1, 0.02, 701), 900, 700), gain=1.5), 0.7)


def lap():
    notes = tone(0.5, 660, 0.2)
    return wav(add(notes, tone(0.6, 990, 0.3), 0.12), 0.5)


def bounce():
    return wav(marimba(440, 0.25), 0.5)


def brick():
    body = modes(0.3, [(880, 1.0, 0.08), (1760 * 1.02, 0.4, 0.05), (2640, 0.2, 0.03)])
    return wav(add(body, resonate(noise(0.06, 0.01, 702), 2600, 1500), gain=1.2), 0.6)


def lose():
    return wav(tone(0.7, 330, 0.3, 110), 0.6)


SOUNDS = {
    "racer": {"engine": engine, "bump": bump, "lap": lap},
    "breakout": {"bounce": bounce, "brick": brick, "lose": lose},
}
