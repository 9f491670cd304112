# Every sound of the slingshot, by name.
# Invariant: SOUNDS is the whole list; games/slingshot/src/sound.lua plays files of the same names.
import random

from synth import add, marimba, modes, noise, pluck, resonate, seconds, tone, wav


def wood_hit(variant):
    base = (235, 290, 205)[variant]
    body = modes(0.28, [(base, 1.0, 0.050), (base * 2.41, 0.55, 0.034), (base * 4.33, 0.30, 0.020),
                        (base * 6.9, 0.16, 0.011)])
    add(body, resonate(noise(0.05, 0.008, 100 + variant), 1900, 900), gain=1.6)
    return wav(body, 0.75)


def stone_hit(variant):
    base = (410, 352, 478)[variant]
    body = modes(0.22, [(base, 0.8, 0.026), (base * 2.76, 0.7, 0.022), (base * 4.1, 0.45, 0.016),
                        (base * 7.3, 0.30, 0.010), (92, 0.9, 0.040)])
    add(body, resonate(noise(0.08, 0.012, 200 + variant), 3100, 1800), gain=2.2)
    add(body, resonate(noise(0.16, 0.045, 210 + variant), 620, 500), 0.006, 0.8)
    return wav(body, 0.8)


def ice_hit(variant):
    base = (1480, 1720, 1310)[variant]
    body = modes(0.40, [(base, 0.8, 0.070), (base * 1.53, 0.45, 0.055), (base * 2.32, 0.5, 0.045),
                        (base * 3.19, 0.35, 0.030), (base * 4.4, 0.20, 0.018)])
    add(body, resonate(noise(0.03, 0.005, 300 + variant), 5200, 2600), gain=1.4)
    return wav(body, 0.6)


def _rubble(duration_s, grains, grain, seed):
    """Many small hits, dense at first."""
    source, result = random.Random(seed), seconds(duration_s)
    for _ in range(grains):
        at = duration_s * 0.75 * source.random() ** 2.2
        add(result, grain(source), at, (0.25 + 0.75 * source.random()) * (1 - at / duration_s))
    return result


def wood_break():
    snap = resonate(noise(0.09, 0.014, 401), 1300, 1100)
    crack = _rubble(0.5, 16, lambda s: modes(0.09, [(300 + 500 * s.random(), 1.0, 0.018),
                                                    (1300 + 900 * s.random(), 0.6, 0.009)]), 402)
    add(crack, snap, gain=6.0)
    add(crack, tone(0.2, 170, 0.05, 90), gain=1.3)
    return wav(crack, 0.85)


def stone_break():
    rocks = _rubble(0.65, 22, lambda s: modes(0.1, [(260 + 420 * s.random(), 1.0, 0.020),
                                                    (1100 + 1200 * s.random(), 0.5, 0.008)]), 412)
    add(rocks, resonate(noise(0.4, 0.10, 411), 480, 420), gain=4.0)
    add(rocks, tone(0.25, 110, 0.07, 58), gain=1.8)
    return wav(rocks, 0.9)


def ice_break():
    shards = _rubble(0.75, 30, lambda s: modes(0.22, [(1700 + 2600 * s.random(), 1.0, 0.045),
                                                      (4200 + 2400 * s.random(), 0.5, 0.025)]), 422)
    add(shards, resonate(noise(0.08, 0.012, 421), 4600, 3000), gain=5.0)
    return wav(shards, 0.7)


def stretch():
    """Leather that creaks: clicks that come faster and higher as the band tightens."""
    source, result, t = random.Random(431), seconds(0.55), 0.0
    while t < 0.46:
        u = t / 0.46
        click = resonate(noise(0.03, 0.006, int(1e6 * t) + 7), 380 + 420 * u, 160)
        add(result, click, t, 0.5 + 0.5 * u)
        t += 0.030 - 0.016 * u + 0.006 * source.random()
    return wav(result, 0.5)


def launch():
    result = pluck(0.40, 118, 441, 0.62, 0.985)
    swish = resonate(noise(0.42, 0.14, 442, attack_s=0.05), 1500, 700, 420)
    add(result, swish, 0.01, 3.2)
    return wav(result, 0.75)


def pebble_hit():
    body = modes(0.16, [(620, 0.9, 0.020), (1710, 0.6, 0.013), (130, 1.0, 0.035)])
    add(body, resonate(noise(0.04, 0.006, 451), 2400, 1500), gain=1.5)
    return wav(body, 0.7)


def grump_mutter():
    """A short indignant "mph"."""
    result = tone(0.22, 300, 0.09, 205, attack_s=0.012, vibrato=0.03)
    add(result, tone(0.22, 600, 0.06, 410, attack_s=0.012), gain=0.45)
    add(result, tone(0.22, 905, 0.04, 615, attack_s=0.012), gain=0.2)
    return wav(result, 0.6)


def grump_pop():
    result = tone(0.13, 240, 0.10, 980, attack_s=0.004)
    add(result, resonate(noise(0.10, 0.02, 461), 1400, 900), 0.11, 2.6)
    add(result, tone(0.20, 1180, 0.05, 700), 0.115, 0.7)
    for i in range(4):
        add(result, tone(0.12, 1500 + 340 * i, 0.030), 0.17 + 0.035 * i, 0.16)
    return wav(result, 0.8)


def thud():
    body = modes(0.22, [(78, 1.0, 0.055), (141, 0.45, 0.032)])
    add(body, resonate(noise(0.12, 0.025, 471), 320, 300), gain=1.6)
    return wav(body, 0.8)


def star():
    result = seconds(0.8)
    for i, hz in enumerate((1046.5, 1568.0, 2093.0)):
        add(result, modes(0.7, [(hz, 1.0, 0.20), (hz * 2.76, 0.22, 0.09)]), 0.045 * i, 0.8)
    return wav(result, 0.55)


def _phrase(notes, step_s):
    """Notes are (step, MIDI number, gain)."""
    result = seconds(0.1)
    for step, number, gain in notes:
        add(result, marimba(440 * 2 ** ((number - 69) / 12)), step * step_s, gain)
    return result


def win():
    tune = [(0, 67, 0.8), (1, 72, 0.9), (2, 76, 0.9), (3, 79, 1.0), (5, 76, 0.8), (6, 79, 0.9), (7, 84, 1.1),
            (7, 76, 0.6), (7, 60, 0.8), (0, 48, 0.7), (3, 55, 0.7)]
    return wav(_phrase(tune, 0.125), 0.8)


def lose():
    tune = [(0, 67, 0.9), (2, 64, 0.9), (4, 60, 0.9), (6, 57, 1.0), (6, 45, 0.9)]
    return wav(_phrase(tune, 0.15), 0.7)


def button():
    return wav(modes(0.09, [(880, 1.0, 0.016), (1760, 0.4, 0.010)]), 0.45)


SOUNDS = {
    **{f"wood-hit-{i + 1}": (lambda i=i: wood_hit(i)) for i in range(3)},
    **{f"stone-hit-{i + 1}": (lambda i=i: stone_hit(i)) for i in range(3)},
    **{f"ice-hit-{i + 1}": (lambda i=i: ice_hit(i)) for i in range(3)},
    "wood-break": wood_break,
    "stone-break": stone_break,
    "ice-break": ice_break,
    "stretch": stretch,
    "launch": launch,
    "pebble-hit": pebble_hit,
    "grump-mutter": grump_mutter,
    "grump-pop": grump_pop,
    "thud": thud,
    "star": star,
    "win": win,
    "lose": lose,
    "button": button,
}
