# A picture painted from shapes given by their signed distance, which makes every edge exactly one pixel soft.
# Invariant: pixels hold colour times alpha (premultiplied), 0..1; y points down; the unit of all shapes is the pixel
# of the design, and `scale` of the canvas says how many pixels of the file that is.
# Source: signed distances of Quilez's catalogue of 2D primitives; blending after Porter and Duff 1984.
import math

import png
from noise import clamp


class Shape:
    """A signed distance (negative inside) and a box outside of which nothing is painted."""

    def __init__(self, distance, box):
        self.distance = distance
        self.box = box

    def grown(self, by):
        x0, y0, x1, y1 = self.box
        grow = max(by, 0)
        return Shape(lambda x, y: self.distance(x, y) - by, (x0 - grow, y0 - grow, x1 + grow, y1 + grow))

    def moved(self, dx, dy):
        x0, y0, x1, y1 = self.box
        return Shape(lambda x, y: self.distance(x - dx, y - dy), (x0 + dx, y0 + dy, x1 + dx, y1 + dy))

    def turned(self, angle, cx=0.0, cy=0.0):
        c, s = math.cos(angle), math.sin(angle)
        x0, y0, x1, y1 = self.box
        corners = [(x0, y0), (x1, y0), (x0, y1), (x1, y1)]
        xs = [cx + c * (x - cx) - s * (y - cy) for x, y in corners]
        ys = [cy + s * (x - cx) + c * (y - cy) for x, y in corners]

        def distance(x, y):
            dx, dy = x - cx, y - cy
            return self.distance(cx + c * dx + s * dy, cy - s * dx + c * dy)

        return Shape(distance, (min(xs), min(ys), max(xs), max(ys)))

    def __or__(self, other):
        a, b = self.box, other.box
        box = (min(a[0], b[0]), min(a[1], b[1]), max(a[2], b[2]), max(a[3], b[3]))
        return Shape(lambda x, y: min(self.distance(x, y), other.distance(x, y)), box)

    def __and__(self, other):
        a, b = self.box, other.box
        box = (max(a[0], b[0]), max(a[1], b[1]), min(a[2], b[2]), min(a[3], b[3]))
        return Shape(lambda x, y: max(self.distance(x, y), other.distance(x, y)), box)

    def __sub__(self, other):
        return Shape(lambda x, y: max(self.distance(x, y), -other.distance(x, y)), self.box)


def circle(cx, cy, r):
    return Shape(lambda x, y: math.hypot(x - cx, y - cy) - r, (cx - r, cy - r, cx + r, cy + r))


def ellipse(cx, cy, rx, ry):
    """Exact on the border and near it, which is all that painting needs: the implicit function over its gradient."""

    def distance(x, y):
        px, py = (x - cx) / rx, (y - cy) / ry
        k = math.hypot(px, py)
        slope = math.hypot(px / rx, py / ry)
        return k * (k - 1) / slope if slope > 1e-9 else -min(rx, ry)

    return Shape(distance, (cx - rx, cy - ry, cx + rx, cy + ry))


def box(x0, y0, x1, y1, radius=0.0):
    cx, cy, hx, hy = (x0 + x1) / 2, (y0 + y1) / 2, (x1 - x0) / 2 - radius, (y1 - y0) / 2 - radius

    def distance(x, y):
        dx, dy = abs(x - cx) - hx, abs(y - cy) - hy
        return math.hypot(max(dx, 0), max(dy, 0)) + min(max(dx, dy), 0) - radius

    return Shape(distance, (x0, y0, x1, y1))


def taper(ax, ay, bx, by, ra, rb=None):
    """A stroke from a to b whose half-width goes from ra to rb."""
    rb = ra if rb is None else rb
    dx, dy = bx - ax, by - ay
    length2 = dx * dx + dy * dy or 1e-9
    r = max(ra, rb)

    def distance(x, y):
        t = clamp(((x - ax) * dx + (y - ay) * dy) / length2)
        return math.hypot(x - ax - t * dx, y - ay - t * dy) - (ra + (rb - ra) * t)

    return Shape(distance, (min(ax, bx) - r, min(ay, by) - r, max(ax, bx) + r, max(ay, by) + r))


def stroke(points, ra, rb=None):
    """A tapering stroke along a polyline."""
    rb = ra if rb is None else rb
    n = len(points) - 1
    parts = [
        taper(*points[i], *points[i + 1], ra + (rb - ra) * i / n, ra + (rb - ra) * (i + 1) / n) for i in range(n)
    ]
    result = parts[0]
    for part in parts[1:]:
        result = result | part
    return result


def polygon(points):
    edges = [(points[i - 1], points[i]) for i in range(len(points))]

    def distance(x, y):
        best, inside = 1e18, False
        for (ax, ay), (bx, by) in edges:
            ex, ey, wx, wy = bx - ax, by - ay, x - ax, y - ay
            t = clamp((wx * ex + wy * ey) / (ex * ex + ey * ey or 1e-9))
            dx, dy = wx - ex * t, wy - ey * t
            best = min(best, dx * dx + dy * dy)
            if (ay > y) != (by > y) and x < ax + (y - ay) * ex / ey:
                inside = not inside
        return -math.sqrt(best) if inside else math.sqrt(best)

    xs, ys = [p[0] for p in points], [p[1] for p in points]
    return Shape(distance, (min(xs), min(ys), max(xs), max(ys)))


def curve(points, steps=8, closed=True):
    """Points on the Catmull-Rom spline through the given ones."""
    n, result = len(points), []
    for i in range(n if closed else n - 1):
        if closed:
            p0, p1, p2, p3 = (points[(i + k) % n] for k in (-1, 0, 1, 2))
        else:
            p0, p1, p2, p3 = (points[min(max(i + k, 0), n - 1)] for k in (-1, 0, 1, 2))
        for s in range(steps):
            t = s / steps
            result.append(
                tuple(
                    0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t + (3 * b - a - 3 * c + d) * t**3)
                    for a, b, c, d in zip(p0, p1, p2, p3)
                )
            )
    if not closed:
        result.append(points[-1])
    return result


def blob(points, steps=8):
    return polygon(curve(points, steps))


class Canvas:
    def __init__(self, width, height, scale=1.0):
        self.width, self.height, self.scale = round(width * scale), round(height * scale), scale
        self.pixels = [(0.0, 0.0, 0.0, 0.0)] * (self.width * self.height)

    def fill(self, shape, paint, opacity=1.0, soft=0.0):
        """Paints a colour, or paint(x, y) giving one, of 3 or 4 numbers. `soft` blurs the edge over that many units."""
        scale = self.scale
        margin = soft / 2 + 1 / scale
        x0 = max(0, math.floor((shape.box[0] - margin) * scale))
        y0 = max(0, math.floor((shape.box[1] - margin) * scale))
        x1 = min(self.width, math.ceil((shape.box[2] + margin) * scale))
        y1 = min(self.height, math.ceil((shape.box[3] + margin) * scale))
        edge = max(soft, 1 / scale)
        distance, pixels, plain = shape.distance, self.pixels, not callable(paint)
        for py in range(y0, y1):
            y = (py + 0.5) / scale
            row = py * self.width
            for px in range(x0, x1):
                x = (px + 0.5) / scale
                cover = 0.5 - distance(x, y) / edge
                if cover <= 0:
                    continue
                if cover > 1:
                    cover = 1.0
                if soft:
                    cover = cover * cover * (3 - 2 * cover)
                color = paint if plain else paint(x, y)
                alpha = cover * opacity * (color[3] if len(color) > 3 else 1.0)
                r, g, b, a = pixels[row + px]
                keep = 1 - alpha
                pixels[row + px] = (
                    color[0] * alpha + r * keep,
                    color[1] * alpha + g * keep,
                    color[2] * alpha + b * keep,
                    alpha + a * keep,
                )

    def paint(self, color_at):
        """Sets every pixel to color_at(x, y), 3 or 4 numbers, not premultiplied."""
        for py in range(self.height):
            for px in range(self.width):
                color = color_at((px + 0.5) / self.scale, (py + 0.5) / self.scale)
                a = color[3] if len(color) > 3 else 1.0
                self.pixels[py * self.width + px] = (color[0] * a, color[1] * a, color[2] * a, a)

    def png(self, alpha=True, matte=(0.24, 0.17, 0.15)):
        """`matte` is the colour of clear pixels: linear filtering mixes it into the outermost pixels of a sprite."""
        clear = tuple(int(v * 255 + 0.5) for v in matte) + (0,)

        def quantized(pixel):
            r, g, b, a = pixel
            if a <= 0.5 / 255:
                return clear
            return tuple(int(clamp(v / a) * 255 + 0.5) for v in (r, g, b)) + (int(clamp(a) * 255 + 0.5),)

        return png.encode(self.width, self.height, [quantized(p) for p in self.pixels], alpha)
