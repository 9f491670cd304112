# Sky, clouds, three ranges of hills, the ground and what grows on it.
# Invariant: the hills and the ground repeat along x without a seam: their waves have whole periods in their width.
import math

import palette as p
from canvas import Canvas, Shape, blob, circle, ellipse, polygon, taper
from characters import lit, outlined
from noise import fractal_noise, hash01, mix_color, smoothstep

HILL_WIDTH = 1280


def sky():
    """Half size: it has no detail, so stretching it to 1280 x 720 shows none of it."""
    canvas = Canvas(1280, 720, 0.5)
    sun_x, sun_y = 985, 175

    def color_at(x, y):
        t = y / 720
        color = mix_color(p.SKY_TOP, p.SKY_MIDDLE, smoothstep(0.0, 0.45, t))
        color = mix_color(color, p.SKY_LOW, smoothstep(0.30, 0.72, t))
        d = math.hypot(x - sun_x, y - sun_y)
        color = mix_color(color, p.SUN, 0.75 * math.exp(-((d / 190) ** 1.3)))
        return mix_color(color, p.SUN, smoothstep(66, 62, d))

    canvas.paint(color_at)
    return canvas.png(alpha=False)


def cloud(kind):
    """A heap of puffs on a flat base, 260 x 100."""
    puffs = (
        [(62, 62, 30), (104, 46, 38), (152, 50, 36), (196, 64, 27), (130, 66, 30)],
        [(70, 66, 24), (110, 56, 32), (160, 62, 26), (198, 70, 18), (40, 74, 15)],
    )[kind]
    shape = taper(46, 82, 214, 82, 12)
    for x, y, r in puffs:
        shape = shape | circle(x, y, r)
    canvas = Canvas(260, 100)
    canvas.fill(
        shape,
        lambda x, y: mix_color(p.CLOUD, p.CLOUD_SHADE, smoothstep(46, 96, y + 6 * math.sin(x * 0.07))),
        0.92,
        soft=2,
    )
    return canvas.png(matte=p.CLOUD)


def _ridge(waves, base):
    """The height of a ridge over x: waves are (periods in the width, amplitude, phase)."""
    return lambda x: base + sum(
        amplitude * math.sin(2 * math.pi * n * x / HILL_WIDTH + phase) for n, amplitude, phase in waves
    )


def _under(ridge, height):
    """Everything below the ridge, as a shape; the slope turns heights into distances."""

    def distance(x, y):
        slope = (ridge(x + 1) - ridge(x - 1)) / 2
        return (ridge(x) - y) / math.hypot(1, slope)

    return Shape(distance, (0, 0, HILL_WIDTH, height))


def _around(x, radius):
    """The places where a thing at x must be painted so that it shows on both sides of the seam."""
    return [x] + ([x + HILL_WIDTH] if x < radius else []) + ([x - HILL_WIDTH] if x > HILL_WIDTH - radius else [])


def _tree(canvas, x, y, size, dark, light):
    for ax in _around(x, size):
        crown = circle(ax, y - size * 0.9, size * 0.55) | circle(ax - size * 0.38, y - size * 0.55, size * 0.42)
        crown = crown | circle(ax + size * 0.40, y - size * 0.50, size * 0.40)
        canvas.fill(taper(ax, y + 3, ax, y - size * 0.5, size * 0.09), mix_color(dark, p.EARTH_DARK, 0.4))

        def shade(px, py, ax=ax):
            depth = ((px - ax) * 0.5 + py - y + size * 0.8) / size
            return mix_color(light, dark, smoothstep(-0.5, 0.6, depth))

        canvas.fill(crown, shade)


def _stones(canvas, x, y, size, dark, light):
    """A cairn, far away."""
    for ax in _around(x, size):
        top = y
        for width, height in ((0.62, 0.30), (0.48, 0.27), (0.36, 0.22), (0.22, 0.17)):
            h = size * height
            stone = ellipse(ax + size * 0.05 * math.sin(top), top - h / 2, size * width / 2, h / 2 + 0.5)
            canvas.fill(stone, lambda px, py, t=top, h=h: mix_color(light, dark, smoothstep(t - h, t, py)))
            top -= h * 0.94


def far_hills():
    height = 260
    canvas = Canvas(HILL_WIDTH, height)
    back = _ridge([(2, 34, 0.4), (3, 22, 1.9), (7, 6, 0.3)], 78)
    canvas.fill(
        _under(back, height), lambda x, y: mix_color(p.FAR_HILL, p.FAR_HILL_LOW, smoothstep(30, 190, y)) + (0.75,)
    )
    front = _ridge([(1, 20, 2.6), (3, 26, 4.2), (5, 9, 1.2)], 130)
    canvas.fill(
        _under(front, height),
        lambda x, y: mix_color(mix_color(p.FAR_HILL, p.MIDDLE_HILL, 0.25), p.FAR_HILL_LOW, smoothstep(90, 230, y)),
    )
    return canvas.png(matte=p.FAR_HILL)


def middle_hills():
    height = 250
    canvas = Canvas(HILL_WIDTH, height)
    ridge = _ridge([(2, 26, 3.3), (3, 20, 0.6), (5, 8, 2.2)], 92)
    for i in range(34):
        x = hash01(i, 1, 5) * HILL_WIDTH
        if fractal_noise(x / 160, 0.5, 8, 1, 7, 1) > 0.48:
            light = mix_color(p.MIDDLE_HILL_LOW, p.MIDDLE_HILL, 0.3)
            _tree(canvas, x, ridge(x) + 2, 15 + 11 * hash01(i, 2, 5), p.MIDDLE_HILL, light)
    dark, light = mix_color(p.STONE, p.MIDDLE_HILL, 0.55), mix_color(p.STONE_LIGHT, p.FAR_HILL_LOW, 0.6)
    _stones(canvas, 905, ridge(905) + 3, 40, dark, light)
    canvas.fill(
        _under(ridge, height),
        lambda x, y: mix_color(p.MIDDLE_HILL, p.MIDDLE_HILL_LOW, smoothstep(ridge(x), ridge(x) + 130, y)),
    )
    return canvas.png(matte=p.MIDDLE_HILL)


def near_hills():
    height = 230
    canvas = Canvas(HILL_WIDTH, height)
    ridge = _ridge([(1, 22, 5.2), (2, 24, 1.1), (4, 8, 0.2)], 96)
    for i in range(20):
        x = hash01(i, 3, 9) * HILL_WIDTH
        if fractal_noise(x / 128, 0.5, 10, 1, 15, 1) > 0.50:
            dark = mix_color(p.NEAR_HILL, p.GRASS_DARK, 0.45)
            _tree(canvas, x, ridge(x) + 4, 26 + 20 * hash01(i, 4, 9), dark, p.NEAR_HILL_LOW)
    for x, size in ((300, 66), (352, 40)):
        dark, light = mix_color(p.STONE_DARK, p.NEAR_HILL, 0.25), mix_color(p.STONE_LIGHT, p.NEAR_HILL_LOW, 0.2)
        _stones(canvas, x, ridge(x) + 5, size, dark, light)

    def color_at(x, y):
        depth = y - ridge(x)
        color = mix_color(p.NEAR_HILL, p.NEAR_HILL_LOW, smoothstep(0, 120, depth))
        stripe = math.sin(depth * 0.16 + 2.2 * math.sin(2 * math.pi * 3 * x / HILL_WIDTH))
        return mix_color(color, p.NEAR_HILL_LOW, 0.22 * smoothstep(0.3, 0.8, stripe))

    canvas.fill(_under(ridge, height), color_at)
    return canvas.png(matte=p.NEAR_HILL)


GROUND_SIZE = (512, 280)
GROUND_LINE = 30


def ground():
    """Turf over earth; the surface lies GROUND_LINE pixels under the top, the blades stand above it."""
    width, height = GROUND_SIZE
    canvas = Canvas(width, height)

    def soil(x, y):
        u, v = x / width, y / width
        color = mix_color(p.EARTH, p.EARTH_DARK, smoothstep(GROUND_LINE + 20, height, y))
        blotch = fractal_noise(u * 8, v * 10, 8, 1024, 81, 3)
        color = mix_color(color, p.EARTH_DARK, 0.35 * smoothstep(0.5, 0.72, blotch))
        return mix_color(color, p.EARTH_STONE, 0.22 * smoothstep(0.46, 0.3, blotch))

    canvas.fill(polygon([(-9, GROUND_LINE), (width + 9, GROUND_LINE), (width + 9, height + 9), (-9, height + 9)]), soil)
    for i in range(22):
        x, y = hash01(i, 1, 83) * width, GROUND_LINE + 62 + hash01(i, 2, 83) * 165
        r = 4 + 8 * hash01(i, 3, 83)
        for ax in (x - width, x, x + width):
            canvas.fill(ellipse(ax, y, r * 1.35, r), lit(p.EARTH_DARK, p.EARTH_STONE, p.EMPTY, ax, y, r), 0.55)

    def turf_edge(x):
        wave = 2 * math.pi * x / width
        scallop = abs(math.sin(wave * 8 + 0.7 * math.sin(wave * 3)))
        return GROUND_LINE + 26 + 13 * scallop + 5 * math.sin(wave * 5 + 1)

    def turf(x, y):
        t = (y - GROUND_LINE) / (turf_edge(x) - GROUND_LINE)
        color = mix_color(p.GRASS_LIGHT, p.GRASS, smoothstep(0.0, 0.35, t))
        return mix_color(color, p.GRASS_DARK, smoothstep(0.55, 1.0, t))

    def turf_distance(x, y):
        slope = (turf_edge(x + 1) - turf_edge(x - 1)) / 2
        return max((y - turf_edge(x)) / math.hypot(1, slope), GROUND_LINE - y)

    turf_shape = Shape(turf_distance, (0, GROUND_LINE, width, GROUND_LINE + 60))
    canvas.fill(turf_shape.moved(0, 5), p.INK, 0.28, soft=6)
    canvas.fill(turf_shape, turf)
    for i in range(74):
        x = (i + 0.7 * hash01(i, 1, 87)) * width / 74
        tall, lean = 7 + 11 * hash01(i, 2, 87), 8 * (hash01(i, 3, 87) - 0.5)
        tint = mix_color(p.GRASS, p.GRASS_LIGHT, hash01(i, 4, 87))
        for ax in (x - width, x, x + width):
            canvas.fill(taper(ax, GROUND_LINE + 3, ax + lean, GROUND_LINE - tall, 2.6, 0.5), tint)
    return canvas.png(matte=p.GRASS)


def tuft():
    """Blades and a daisy, 72 x 52, for the foot of things."""
    canvas = Canvas(72, 52)
    for i in range(13):
        x = 8 + i * 4.6
        lean, tall = (x - 36) * 0.42 + 5 * (hash01(i, 1, 91) - 0.5), 18 + 22 * hash01(i, 2, 91) - abs(x - 36) * 0.25
        tint = mix_color(p.GRASS_DARK, p.GRASS_LIGHT, hash01(i, 3, 91))
        canvas.fill(taper(x, 54, x + lean, 52 - tall, 3.4, 0.5), tint)
    for k in range(6):
        a = k * math.pi / 3
        canvas.fill(ellipse(47 + 5 * math.cos(a), 17 + 5 * math.sin(a), 3.4, 3.4), p.CREAM)
    canvas.fill(circle(47, 17, 3.3), p.GOLD)
    return canvas.png(matte=p.GRASS)


def cairn():
    """A stack of five stones, 120 x 150, drawn as carefully as the pieces."""
    canvas = Canvas(120, 150)
    base = 146
    for i, (width, height, dx) in enumerate(((104, 42, 0), (84, 34, 4), (66, 30, -4), (46, 24, 3), (28, 19, -1))):
        cx, cy, rx, ry = 60 + dx, base - height / 2, width / 2, height / 2
        stone = blob([(cx + rx * math.cos(a) * k, cy + ry * math.sin(a) * k) for a, k in
                      zip([j * math.pi / 4 for j in range(8)], [0.96 + 0.1 * hash01(i, j, 93) for j in range(8)])])
        outlined(canvas, stone, lit(p.STONE_DARK, p.STONE, p.STONE_LIGHT, cx, cy, rx * 0.8), 3.0)
        canvas.fill(ellipse(cx - rx * 0.3, cy - ry * 0.45, rx * 0.3, ry * 0.16), p.CREAM, 0.35, soft=4)
        base -= height - 3
    moss = blob([(14, 126), (30, 108), (46, 107), (40, 116), (32, 116), (24, 132)])
    canvas.fill(moss, p.MOSS, 0.8)
    return canvas.png()
