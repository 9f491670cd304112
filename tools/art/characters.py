# The pebbles that are thrown, the sulky turnips ("grumps") that are thrown at, and the forked slingshot.
# Invariant: 100 pixels are a metre; each body is centred on its picture's CENTER, which games/slingshot/src/art.lua
# repeats. Light comes from the upper left; everything has one dark outline.
import math

import palette as p
from canvas import Canvas, blob, circle, curve, ellipse, polygon, stroke, taper
from noise import clamp, mix_color, smoothstep

OUTLINE = 3.2


def lit(dark, base, light, cx, cy, r):
    """A paint for a round thing: light from the upper left, dark to the lower right."""

    def color_at(x, y):
        t = ((x - cx) + (y - cy) * 1.3) / (r * 2.3)
        if t < 0:
            return mix_color(base, light, smoothstep(0.05, 0.55, -t))
        return mix_color(base, dark, smoothstep(0.05, 0.60, t))

    return color_at


def outlined(canvas, shape, paint, width=OUTLINE, ink=p.INK):
    canvas.fill(shape.grown(width / 2), ink)
    canvas.fill(shape.grown(-width / 2), paint)


def eye(canvas, x, y, rx, ry, look_x, look_y, pupil):
    outlined(canvas, ellipse(x, y, rx, ry), p.CREAM, 2.4)
    canvas.fill(circle(x + look_x, y + look_y, pupil), p.INK)
    canvas.fill(circle(x + look_x - pupil * 0.35, y + look_y - pupil * 0.4, pupil * 0.36), p.CREAM)


def pebble():
    """A keen round pebble, radius 33, with a cap of moss."""
    canvas = Canvas(80, 80)
    c = 40
    body = blob([(c + 32 * math.cos(a) * k, c + 32 * math.sin(a) * k)
                 for a, k in zip([i * math.pi / 4 for i in range(8)],
                                 (1.02, 0.99, 1.03, 1.0, 1.02, 0.98, 1.02, 1.0))])
    outlined(canvas, body, lit(p.PEBBLE_DARK, p.PEBBLE, p.PEBBLE_LIGHT, c, c, 32))
    inner = body.grown(-OUTLINE / 2)
    moss = blob([(8, 30), (14, 14), (30, 5), (48, 7), (56, 16), (47, 21), (39, 18), (32, 24), (24, 22), (18, 31)])
    canvas.fill(moss.grown(1.4) & inner, p.INK, 0.55)
    canvas.fill(moss & inner, lit(p.LEAF, p.MOSS, p.GRASS_LIGHT, 30, 18, 26))
    for x, y, r in ((58, 56, 2.6), (51, 64, 1.8), (22, 57, 2.0), (65, 46, 1.6)):
        canvas.fill(circle(x, y, r), p.PEBBLE_DARK, 0.8)
    canvas.fill(ellipse(20, 50, 5, 3.4), p.TURNIP_MIDDLE, 0.45, soft=3)
    canvas.fill(ellipse(60, 48, 5, 3.4), p.TURNIP_MIDDLE, 0.45, soft=3)
    eye(canvas, 31, 38, 7.2, 8.6, 2.0, 0.4, 3.9)
    eye(canvas, 51, 37, 7.2, 8.6, 2.0, 0.4, 3.9)
    canvas.fill(stroke(curve([(33, 52), (41, 56), (50, 51)], closed=False), 1.9), p.INK)
    canvas.fill(taper(24, 27.5, 34, 26.5, 1.9), p.INK)
    canvas.fill(taper(47, 25.5, 57, 26.5, 1.9), p.INK)
    return canvas.png()


GRUMP_CENTER = (60, 82)


def grump(mood):
    """A turnip of radius 42 under a tuft of leaves; mood is "cross", "blink" or "hurt"."""
    canvas = Canvas(120, 136)
    cx, cy = GRUMP_CENTER

    def leaf(points, dark):
        shape = blob(points)
        outlined(canvas, shape, lit(p.LEAF_DARK, p.LEAF, p.MOSS, points[0][0], points[0][1] - 18, 24 if dark else 34))

    leaf([(56, 46), (40, 38), (24, 19), (22, 8), (37, 12), (52, 26)], True)
    leaf([(64, 46), (78, 36), (95, 24), (101, 13), (87, 13), (69, 25)], True)
    leaf([(60, 48), (49, 30), (53, 10), (61, 2), (68, 11), (71, 31)], False)
    canvas.fill(stroke(curve([(60, 44), (60, 28), (61, 12)], closed=False), 1.4, 0.8), p.LEAF_DARK)

    body = blob([(cx, cy - 39), (cx + 26, cy - 34), (cx + 41, cy - 10), (cx + 39, cy + 17), (cx + 20, cy + 38),
                 (cx, cy + 42), (cx - 20, cy + 38), (cx - 39, cy + 17), (cx - 41, cy - 10), (cx - 26, cy - 34)])

    def skin(x, y):
        """Purple shoulders that run out in tongues over the pale lower half."""
        angle = math.atan2(x - cx, 60)
        edge = cy - 2 + 5 * math.sin(angle * 16 + 0.6) + 2.5 * math.sin(angle * 37)
        t = smoothstep(edge - 5, edge + 5, y)
        top = mix_color(p.TURNIP_TOP, p.TURNIP_MIDDLE, smoothstep(cy - 30, cy, y))
        color = mix_color(top, p.TURNIP_LOW, t)
        light = ((x - cx) + (y - cy) * 1.2) / 90
        if light < 0:
            return mix_color(color, p.CREAM, 0.42 * smoothstep(0.1, 0.75, -light))
        return mix_color(color, p.TURNIP_TOP, 0.38 * smoothstep(0.15, 0.75, light))

    outlined(canvas, body, skin)
    inner = body.grown(-OUTLINE / 2)
    for x, y, w in ((cx - 33, cy + 22, 9), (cx + 28, cy + 28, 8), (cx - 24, cy + 31, 6), (cx + 33, cy + 14, 5)):
        canvas.fill(taper(x - w / 2, y, x + w / 2, y + 0.8, 0.9) & inner, p.TURNIP_MIDDLE, 0.9)
    for dx in (-15, 0, 14):
        canvas.fill(stroke(curve([(cx + dx * 0.5, cy - 39), (cx + dx, cy - 32), (cx + dx * 1.2, cy - 26)],
                                 closed=False), 1.1, 0.4) & inner, p.INK, 0.35)

    left, right, y = cx - 15, cx + 15, cy + 1
    if mood == "hurt":
        for x in (left, right):
            for s in (-1, 1):
                canvas.fill(taper(x - 6, y - 6 * s, x + 6, y + 6 * s, 2.2), p.INK)
        canvas.fill(stroke(curve([(cx - 12, cy + 24), (cx - 6, cy + 20), (cx, cy + 24), (cx + 6, cy + 20),
                                  (cx + 12, cy + 24)], closed=False), 1.9), p.INK)
        plaster = taper(cx + 17, cy - 24, cx + 31, cy - 15, 5.2)
        outlined(canvas, plaster, p.EMPTY, 2.2)
        canvas.fill(circle(cx + 24, cy - 19.5, 2.0), p.GOLD_DARK)
        canvas.fill(ellipse(cx - 27, cy + 15, 8, 6), p.TURNIP_TOP, 0.5, soft=5)
    elif mood == "blink":
        for x in (left, right):
            canvas.fill(stroke(curve([(x - 9, y - 1), (x, y + 3), (x + 9, y - 1)], closed=False), 2.2), p.INK)
    else:
        eye(canvas, left, y, 9.6, 9.4, -1.2, 1.4, 4.4)
        eye(canvas, right, y, 9.6, 9.4, -1.2, 1.4, 4.4)
        # Heavy lids: the look of one who was woken too early.
        for x in (left, right):
            lid = ellipse(x, y, 9.6, 9.4).grown(1.2) & polygon(
                [(x - 14, y - 14), (x + 14, y - 14),
                 (x + 14, y - 3 + (-3 if x > cx else 2)), (x - 14, y - 3 + (2 if x > cx else -3))])
            canvas.fill(lid, p.INK)
            canvas.fill(lid.grown(-2.3), p.TURNIP_TOP)
    if mood != "hurt":
        canvas.fill(taper(left - 12, y - 18, left + 9, y - 9.5, 3.1, 3.7), p.INK)
        canvas.fill(taper(right + 12, y - 18, right - 9, y - 9.5, 3.1, 3.7), p.INK)
        canvas.fill(stroke(curve([(cx - 13, cy + 27), (cx - 6, cy + 21), (cx + 3, cy + 20), (cx + 13, cy + 25)],
                                 closed=False), 2.2), p.INK)
        canvas.fill(taper(cx - 6, cy + 31, cx + 5, cy + 30, 1.3), p.INK, 0.5)
    return canvas.png()


FORK_SIZE = (170, 300)


def _branch(canvas, points, ra, rb):
    shape = stroke(curve(points, closed=False), ra, rb)
    x0, x1 = min(q[0] for q in points), max(q[0] for q in points)

    def bark(x, y):
        across = clamp((x - x0 + 16) / (x1 - x0 + 32))
        color = mix_color(p.FORK_LIGHT, p.FORK, smoothstep(0.15, 0.5, across))
        color = mix_color(color, p.FORK_DARK, smoothstep(0.55, 0.95, across))
        fibre = math.sin(x * 0.9 + 3 * math.sin(y * 0.045)) * math.sin(y * 0.11 + x * 0.25)
        return mix_color(color, p.FORK_DARK, 0.35 * smoothstep(0.55, 0.9, fibre))

    outlined(canvas, shape, bark)
    return shape


def _binding(canvas, x, y, angle, half_width):
    """Turns of red cord around a prong."""
    for i in range(3):
        turn = taper(x - half_width, y + 6 * i - 1, x + half_width, y + 6 * i + 1, 3.4).turned(angle, x, y)
        outlined(canvas, turn, lit(p.LEATHER, p.BAND, p.BAND, x, y, 14), 1.8)


def fork_front():
    """The trunk and the near prong, whose cord is at (38, 42)."""
    canvas = Canvas(*FORK_SIZE)
    _branch(canvas, [(80, 300), (84, 220), (74, 150), (46, 96), (38, 52), (34, 22)], 17, 11)
    canvas.fill(ellipse(34, 17, 8.5, 4.5), p.INK)
    canvas.fill(ellipse(34, 17, 6.5, 3.0), p.WOOD_LIGHT)
    outlined(canvas, ellipse(83, 196, 7, 9.5), lit(p.FORK_DARK, p.FORK_DARK, p.FORK, 83, 196, 8), 2.2)
    canvas.fill(ellipse(82, 196, 2.2, 4), p.INK, 0.7)
    _binding(canvas, 38, 44, -0.10, 14)
    return canvas.png()


def fork_back():
    """The far prong, whose cord is at (124, 42); darker, since it stands behind."""
    canvas = Canvas(*FORK_SIZE)
    _branch(canvas, [(84, 210), (90, 158), (112, 108), (123, 60), (130, 24)], 16, 10)
    canvas.fill(ellipse(130, 18, 8.0, 4.2), p.INK)
    canvas.fill(ellipse(130, 18, 6.0, 2.8), p.WOOD)
    _binding(canvas, 125, 44, 0.14, 13)
    for i, (r, g, b, a) in enumerate(canvas.pixels):
        canvas.pixels[i] = (r * 0.86, g * 0.84, b * 0.86, a)
    return canvas.png()
