# Writes 8-bit PNG files.
# Invariant: equal pixels give equal bytes: the filter of each row and the compression level are fixed rules.
# Source: PNG (W3C, 2nd edition), section 9 (filters) and 12.8 (choosing them by the least sum of differences).
import struct
import zlib


def _chunk(kind, body):
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def _paeth(a, b, c):
    p = a + b - c
    pa, pb, pc = abs(p - a), abs(p - b), abs(p - c)
    if pa <= pb and pa <= pc:
        return a
    return b if pb <= pc else c


def _filtered(row, above, step):
    """The row under the filter whose bytes, taken as signed numbers, have the least sum."""
    left = bytes(step) + row[:-step]
    above_left = bytes(step) + above[:-step]
    candidates = (
        row,
        bytes((r - a) & 255 for r, a in zip(row, left)),
        bytes((r - b) & 255 for r, b in zip(row, above)),
        bytes((r - _paeth(a, b, c)) & 255 for r, a, b, c in zip(row, left, above, above_left)),
    )
    kinds = (0, 1, 2, 4)
    costs = [sum(v if v < 128 else 256 - v for v in c) for c in candidates]
    best = costs.index(min(costs))
    return bytes((kinds[best],)) + candidates[best]


def encode(width, height, pixels, alpha=True):
    """PNG bytes of rows of (r, g, b, a), 0..255 each, first row on top; without alpha, a is left out."""
    step = 4 if alpha else 3
    above = bytes(width * step)
    packed = bytearray()
    for y in range(height):
        row = bytes(v for pixel in pixels[y * width : (y + 1) * width] for v in pixel[:step])
        packed += _filtered(row, above, step)
        above = row
    header = struct.pack(">IIBBBBB", width, height, 8, 6 if alpha else 2, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + _chunk(b"IHDR", header)
        + _chunk(b"IDAT", zlib.compress(bytes(packed), 9))
        + _chunk(b"IEND", b"")
    )
