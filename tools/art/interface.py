# Stars, buttons, the puff of dust and the program's icon.
import math

import palette as p
from canvas import Canvas, box, circle, curve, polygon, stroke
from characters import lit, outlined
from noise import mix_color, smoothstep


def _star_shape(cx, cy, r):
    points = []
    for i in range(10):
        a = -math.pi / 2 + i * math.pi / 5
        k = r if i % 2 == 0 else r * 0.52
        points.append((cx + k * math.cos(a), cy + k * math.sin(a)))
    return polygon(points).grown(r * 0.12)


def star(full):
    canvas = Canvas(112, 112)
    shape = _star_shape(56, 59, 43)
    if full:
        outlined(canvas, shape, lambda x, y: mix_color(p.GOLD, p.GOLD_DARK, smoothstep(52, 106, y + 0.25 * x)), 4.5)
        canvas.fill(_star_shape(53, 55, 26), p.SUN, 0.40, soft=9)
    else:
        canvas.fill(shape.grown(1.5), p.INK, 0.45)
        canvas.fill(shape.grown(-2.5), p.EMPTY)
    return canvas.png()


def _button():
    canvas = Canvas(72, 72)
    canvas.fill(circle(36, 38, 32), p.INK, 0.30, soft=5)
    outlined(canvas, circle(36, 35, 31), lambda x, y: mix_color(p.CREAM, p.EMPTY, smoothstep(20, 66, y)), 3.5)
    return canvas


def restart_button():
    canvas = _button()
    arc = [(36 + 14.5 * math.cos(a), 35 + 14.5 * math.sin(a)) for a in [math.radians(d) for d in range(-20, 271, 12)]]
    canvas.fill(stroke(arc, 3.0), p.INK)
    canvas.fill(polygon([(36, 11.5), (36, 29.5), (47, 20.5)]).grown(1.2), p.INK)
    return canvas.png()


def pause_button():
    canvas = _button()
    canvas.fill(box(26, 23, 32.5, 47, 2.5) | box(39.5, 23, 46, 47, 2.5), p.INK)
    return canvas.png()


def puff():
    """A soft white ball; the game tints it."""
    canvas = Canvas(64, 64)
    canvas.fill(circle(32, 32, 20), (1.0, 1.0, 1.0), soft=22)
    return canvas.png(matte=(1.0, 1.0, 1.0))


def shadow():
    """A soft dark ball, flattened by the game under what lies on the ground."""
    canvas = Canvas(64, 64)
    canvas.fill(circle(32, 32, 18), p.INK, soft=26)
    return canvas.png(matte=p.INK)


def icon():
    """A cairn of three stones before the evening sun, 256 x 256."""
    canvas = Canvas(256, 256)
    frame = box(8, 8, 248, 248, 52)
    canvas.fill(frame, lambda x, y: mix_color(p.SKY_TOP, p.SKY_LOW, smoothstep(20, 190, y)))
    canvas.fill(circle(172, 92, 46) & frame, p.SUN)
    hill = circle(60, 420, 236) | circle(230, 470, 270)
    canvas.fill(hill & frame, lambda x, y: mix_color(p.NEAR_HILL, p.NEAR_HILL_LOW, smoothstep(180, 250, y)))
    base = 224
    for width, height, dx in ((164, 66, 0), (118, 54, 8), (76, 44, -7)):
        stone = box(128 + dx - width / 2, base - height, 128 + dx + width / 2, base, height * 0.48)
        outlined(canvas, stone, lit(p.STONE_DARK, p.STONE, p.STONE_LIGHT, 128 + dx, base - height / 2, width * 0.42), 6)
        base -= height - 3
    for x in (107, 136):
        canvas.fill(circle(x, 85, 5.5), p.INK)
    canvas.fill(stroke(curve([(113, 96), (121, 100), (130, 96)], closed=False), 2.6), p.INK)
    return canvas.png(matte=p.SKY_TOP)
