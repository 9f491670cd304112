# Noise that repeats, for textures without seams.
# Invariant: every function has the period that it is given, and depends on nothing but its arguments.
# Source: value noise with a quintic fade (Perlin 2002); cells after Worley 1996.
import math


def hash01(*numbers):
    """A number in [0, 1) from integers: the multiply-xorshift mixing of MurmurHash3's finaliser, chained."""
    h = 0x9E3779B9
    for n in numbers:
        h = (h ^ (n & 0xFFFFFFFF)) & 0xFFFFFFFF
        h = ((h ^ (h >> 16)) * 0x85EBCA6B) & 0xFFFFFFFF
        h = ((h ^ (h >> 13)) * 0xC2B2AE35) & 0xFFFFFFFF
        h ^= h >> 16
    return h / 4294967296.0


def mix(a, b, t):
    return a + (b - a) * t


def mix_color(a, b, t):
    return tuple(mix(x, y, t) for x, y in zip(a, b))


def clamp(x, low=0.0, high=1.0):
    return low if x < low else high if x > high else x


def smoothstep(low, high, x):
    t = clamp((x - low) / (high - low))
    return t * t * (3 - 2 * t)


def value_noise(x, y, period_x, period_y, seed):
    """Smooth noise in [0, 1] on the integer lattice, with integer periods."""
    ix, iy = math.floor(x), math.floor(y)
    fx, fy = x - ix, y - iy
    fx = fx * fx * fx * (fx * (fx * 6 - 15) + 10)
    fy = fy * fy * fy * (fy * (fy * 6 - 15) + 10)
    x0, x1 = ix % period_x, (ix + 1) % period_x
    y0, y1 = iy % period_y, (iy + 1) % period_y
    top = mix(hash01(x0, y0, seed), hash01(x1, y0, seed), fx)
    bottom = mix(hash01(x0, y1, seed), hash01(x1, y1, seed), fx)
    return mix(top, bottom, fy)


def fractal_noise(x, y, period_x, period_y, seed, octaves=3):
    """Octaves of value noise, each twice as fine and half as strong, in [0, 1]."""
    total, weight, scale = 0.0, 0.0, 1
    for octave in range(octaves):
        strength = 0.5**octave
        total += strength * value_noise(x * scale, y * scale, period_x * scale, period_y * scale, seed + octave)
        weight += strength
        scale *= 2
    return total / weight


def cells(x, y, period_x, period_y, seed, unit_x=1.0, unit_y=1.0):
    """
    Cells around random points, one in each square of the lattice, as (distance to the nearest border, the cell's id,
    the id behind that border). The distance is in pixels of unit_x by unit_y to a lattice square, to first order:
    the difference of the distances to the two points, over its gradient.
    """
    ix, iy = math.floor(x), math.floor(y)
    near, far = (9.0, 0.0, 0.0, 0), (9.0, 0.0, 0.0, 0)
    for cy in range(iy - 2, iy + 3):
        for cx in range(ix - 2, ix + 3):
            wx, wy = cx % period_x, cy % period_y
            dx = x - (cx + 0.15 + 0.7 * hash01(wx, wy, seed))
            dy = y - (cy + 0.15 + 0.7 * hash01(wx, wy, seed + 1))
            d = math.hypot(dx, dy)
            if d < near[0]:
                far = near
                near = (d, dx, dy, wy * period_x + wx)
            elif d < far[0]:
                far = (d, dx, dy, wy * period_x + wx)
    slope_x = (far[1] / far[0] - near[1] / max(near[0], 1e-9)) / unit_x
    slope_y = (far[2] / far[0] - near[2] / max(near[0], 1e-9)) / unit_y
    return (far[0] - near[0]) / max(math.hypot(slope_x, slope_y), 1e-9), near[3], far[3]
