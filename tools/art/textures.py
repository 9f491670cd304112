# The seamless textures of wood, stone and ice, and the cracks that are laid over them as pieces weaken.
# Invariant: each is 256 x 256 and repeats on both axes, so that a piece of any size and turn can be cut from it.
import math

import palette as p
from canvas import Canvas
from noise import cells, clamp, fractal_noise, hash01, mix_color, smoothstep, value_noise

SIZE = 256


def wood():
    """Grain along x: bands of light and dark bent by slow noise, with thin dark fibres on top."""

    def color_at(x, y):
        u, v = x / SIZE, y / SIZE
        bend = fractal_noise(u * 3, v * 3, 3, 3, 11, 2)
        rings = v * 9 + bend * 2.2
        rings = rings + value_noise(u * 4, v * 9, 4, 9, 13) * 0.5
        # A whole number of rings over the height keeps the seam shut.
        wave = 0.5 + 0.5 * math.sin(2 * math.pi * rings)
        color = mix_color(p.WOOD, p.WOOD_LIGHT, 0.75 * smoothstep(0.35, 1.0, wave))
        color = mix_color(color, p.WOOD_DARK, 0.55 * smoothstep(0.72, 1.0, 1 - wave))
        fibre = value_noise(u * 7, v * 72 + bend * 6, 7, 72, 17)
        color = mix_color(color, p.WOOD_DARK, 0.34 * smoothstep(0.70, 0.95, fibre))
        fibre = value_noise(u * 5, v * 48 + bend * 6, 5, 48, 19)
        return mix_color(color, p.WOOD_LIGHT, 0.40 * smoothstep(0.72, 0.95, fibre))

    canvas = Canvas(SIZE, SIZE)
    canvas.paint(color_at)
    return canvas.png(alpha=False)


def stone():
    """Mottled granite: soft blotches, a few chips in light and shade, fine speckles."""

    def color_at(x, y):
        u, v = x / SIZE, y / SIZE
        blotch = fractal_noise(u * 5, v * 5, 5, 5, 23, 3)
        color = mix_color(p.STONE, p.STONE_LIGHT, smoothstep(0.50, 0.72, blotch))
        color = mix_color(color, p.STONE_DARK, 0.7 * smoothstep(0.50, 0.30, blotch))
        warp = fractal_noise(u * 8, v * 8, 8, 8, 29, 2)
        border, near, _ = cells(u * 7 + warp * 0.5, v * 7 + warp * 0.5, 7, 7, 31, SIZE / 7, SIZE / 7)
        chip = hash01(near, 37)
        color = mix_color(color, p.STONE_LIGHT if chip > 0.5 else p.STONE_DARK, 0.28 * abs(chip - 0.5) * 2)
        color = mix_color(color, p.STONE_DARK, 0.35 * smoothstep(1.8, 0.4, border))
        speckle = value_noise(u * 64, v * 64, 64, 64, 41)
        color = mix_color(color, p.STONE_DARK, 0.5 * smoothstep(0.86, 0.97, speckle))
        return mix_color(color, p.STONE_LIGHT, 0.6 * smoothstep(0.14, 0.03, speckle))

    canvas = Canvas(SIZE, SIZE)
    canvas.paint(color_at)
    return canvas.png(alpha=False)


def ice():
    """Pale and a little clear, with slanting gleams and enclosed bubbles."""
    bubbles = [(hash01(i, 1, 43) * SIZE, hash01(i, 2, 43) * SIZE, 2.0 + 4.5 * hash01(i, 3, 43) ** 2) for i in range(26)]

    def color_at(x, y):
        u, v = x / SIZE, y / SIZE
        cloud = fractal_noise(u * 4, v * 4, 4, 4, 47, 3)
        color = mix_color(p.ICE, p.ICE_LIGHT, 0.8 * smoothstep(0.45, 0.75, cloud))
        color = mix_color(color, p.ICE_DARK, 0.6 * smoothstep(0.48, 0.25, cloud))
        slant = (2 * u + 2 * v + 0.16 * value_noise(u * 6, v * 6, 6, 6, 53)) % 1.0
        gleam = max(smoothstep(0.10, 0.13, slant) * smoothstep(0.30, 0.27, slant),
                    0.7 * smoothstep(0.36, 0.38, slant) * smoothstep(0.44, 0.42, slant))
        color = mix_color(color, p.ICE_LIGHT, 0.55 * gleam)
        for bx, by, r in bubbles:
            dx = abs(x - bx)
            dy = abs(y - by)
            d = math.hypot(min(dx, SIZE - dx), min(dy, SIZE - dy)) - r
            if d < 1.5:
                color = mix_color(color, p.ICE_LIGHT, 0.85 * clamp(1.0 - abs(d)))
        return color + (0.90,)

    canvas = Canvas(SIZE, SIZE)
    canvas.paint(color_at)
    return canvas.png()


def cracks(level, along_grain):
    """
    Cracks of damage level 1, 2 or 3: borders between random cells, shown where the level reaches. A border shown at
    one level is shown at all higher ones, so that damage only ever grows. Wood splits in long splinters along x.
    """
    across, down = (4, 14) if along_grain else (6, 6)
    reach = (0.24, 0.45, 0.72)[level - 1]
    width = (1.5, 1.9, 2.4)[level - 1]

    def color_at(x, y):
        u, v = x / SIZE, y / SIZE
        warp_u = (fractal_noise(u * 9, v * 9, 9, 9, 61, 2) - 0.5) * 0.55
        warp_v = (fractal_noise(u * 9, v * 9, 9, 9, 67, 2) - 0.5) * 0.55

        def darkness(shift):
            """0..1, of the crack that is `shift` pixels to the lower right of here."""
            border, here, there = cells(
                (u + shift / SIZE) * across + warp_u, (v + shift / SIZE) * down + warp_v, across, down, 71,
                SIZE / across, SIZE / down,
            )
            rank = hash01(min(here, there), max(here, there), 73)
            return clamp(width * (1.2 - 0.6 * rank / reach) - border) if rank <= reach else 0.0

        crack = darkness(0)
        lit_edge = darkness(-1.6)
        if crack >= lit_edge * 0.8:
            return p.INK + (0.75 * crack,)
        return p.CREAM + (0.40 * lit_edge,)

    canvas = Canvas(SIZE, SIZE)
    canvas.paint(color_at)
    return canvas.png()
