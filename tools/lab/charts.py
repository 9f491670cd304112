"""Charts as SVG, for the documents that tools/lab/report makes. Axes that bear quantities are logarithmic."""
import html
import math

COLORS = ["#1f5fbf", "#d9690f", "#3a9a3a", "#8a4fbf"]
FONT = 'font-family="sans-serif" stroke="none"'


def text(x, y, words, size=12, anchor="start", weight="normal"):
    return (f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}" font-weight="{weight}">'
            f"{html.escape(words)}</text>")


def line(x1, y1, x2, y2, color, width=1.0):
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{color}" stroke-width="{width}"/>'


def document(width, height, parts):
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
            f'{FONT}>\n<rect width="{width}" height="{height}" fill="white"/>\n' + "\n".join(parts) + "\n</svg>\n")


def decades(low, high):
    """Exponents from below the one to above the other; what is beyond a power of ten by a hair starts no decade."""
    first = math.floor(math.log10(low) + 0.01)
    return range(first, max(first + 1, math.ceil(math.log10(high) - 0.01)) + 1)


def power(exponent):
    """0.001, 1, 1,000; and 10^6 beyond."""
    if exponent >= 6:
        return f"10^{exponent}"
    return f"{10 ** exponent:,}" if exponent >= 0 else f"{10.0 ** exponent:.{-exponent}f}"


def bars(title, unit, groups, names):
    """Horizontal bars, longer is more. `groups`: (label, values), one value or None for each of `names`."""
    left, right, top, thick = 130, 90, 70, 13
    width = 760
    per_group = thick * len(names) + 9
    height = top + per_group * len(groups) + 40
    values = [v for _, row in groups for v in row if v]
    exponents = decades(min(values), max(values))
    span = max(1, exponents[-1] - exponents[0])

    def x(value):
        return left + (width - left - right) * (math.log10(value) - exponents[0]) / span

    parts = [text(left, 24, title, 15, weight="bold")]
    for i, name in enumerate(names):
        parts.append(f'<rect x="{left + 150 * i}" y="36" width="12" height="12" fill="{COLORS[i]}"/>')
        parts.append(text(left + 150 * i + 18, 46, name))
    bottom = height - 36
    for e in exponents:
        parts.append(line(x(10.0 ** e), top - 8, x(10.0 ** e), bottom, "#ddd"))
        parts.append(text(x(10.0 ** e), bottom + 16, power(e), 11, "middle"))
    parts.append(text((left + width - right) / 2, bottom + 32, unit, 12, "middle"))
    for g, (label, row) in enumerate(groups):
        y = top + per_group * g
        parts.append(text(left - 8, y + thick * len(names) / 2 + 4, label, 12, "end"))
        for i, value in enumerate(row):
            at = y + thick * i
            if not value:
                parts.append(text(left + 4, at + 10, "none", 10))
                continue
            parts.append(f'<rect x="{left}" y="{at}" width="{max(1.0, x(value) - left):.1f}" height="{thick - 2}" '
                         f'fill="{COLORS[i]}"/>')
            parts.append(text(x(value) + 4, at + 10, f"{value:.3g}", 10))
    return document(width, height, parts)


def curves(title, x_label, y_label, series):
    """Both axes logarithmic. `series`: (name, [(x, y)])."""
    width, height, left, right, top, bottom = 760, 440, 80, 30, 70, 60
    points = [p for _, row in series for p in row]
    across, up = decades(*limits(p[0] for p in points)), decades(*limits(p[1] for p in points))

    def x(value):
        return left + (width - left - right) * (math.log10(value) - across[0]) / max(1, across[-1] - across[0])

    def y(value):
        return height - bottom - (height - top - bottom) * (math.log10(value) - up[0]) / max(1, up[-1] - up[0])

    parts = [text(left, 24, title, 15, weight="bold")]
    for e in across:
        parts.append(line(x(10.0 ** e), top, x(10.0 ** e), height - bottom, "#ddd"))
        parts.append(text(x(10.0 ** e), height - bottom + 18, power(e), 11, "middle"))
    for e in up:
        parts.append(line(left, y(10.0 ** e), width - right, y(10.0 ** e), "#ddd"))
        parts.append(text(left - 6, y(10.0 ** e) + 4, power(e), 11, "end"))
    parts.append(text((left + width - right) / 2, height - 18, x_label, 12, "middle"))
    parts.append(text(left, top - 8, y_label, 12))
    for i, (name, row) in enumerate(series):
        color = COLORS[i % len(COLORS)]
        path = " ".join(f"{x(a):.1f},{y(b):.1f}" for a, b in row)
        parts.append(f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="2"/>')
        parts += [f'<circle cx="{x(a):.1f}" cy="{y(b):.1f}" r="3.5" fill="{color}"/>' for a, b in row]
        parts.append(f'<rect x="{left + 170 * i}" y="36" width="12" height="12" fill="{color}"/>')
        parts.append(text(left + 170 * i + 18, 46, name))
    return document(width, height, parts)


def limits(values):
    values = list(values)
    return min(values), max(values)
