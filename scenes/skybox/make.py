#!/usr/bin/env python3
"""Draws the six faces of this skybox: a dim studio at dusk, with soft lamps to be mirrored in metal
and glass. Needs nothing but Python; run it to rewrite the images beside it."""
import math
import pathlib
import struct
import zlib

SIZE = 128

# The direction a face's texel looks in, from its place (s to the right, t upwards, both in
# [-1, 1]), seen from inside. +X is on the left.
FACES = {
    "right": lambda s, t: (-1, t, -s),
    "left": lambda s, t: (1, t, s),
    "top": lambda s, t: (-s, 1, -t),
    "bottom": lambda s, t: (-s, -1, t),
    "front": lambda s, t: (-s, t, 1),
    "back": lambda s, t: (s, t, -1),
}

# What shines: direction, half width and half height (tangents of angles), softness of the rim,
# colour, half width of a window's bars.
LAMPS = [
    ((-0.75, 0.50, 0.50), 0.34, 0.42, 0.03, (1.00, 0.95, 0.84), 0.03),  # a window, at -X
    ((0.90, 0.35, 0.40), 0.16, 0.50, 0.04, (0.62, 0.74, 0.90), None),  # a cool strip, at +X
    ((0.25, 0.55, -0.95), 0.60, 0.10, 0.05, (0.78, 0.66, 0.55), None),  # a low one at the back
]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return tuple(a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3] for k in range(3))


def unit(v):
    return tuple(x / math.sqrt(dot(v, v)) for x in v)


def smooth(x):
    x = min(1.0, max(0.0, x))
    return x * x * (3 - 2 * x)


def mix(a, b, w):
    return tuple(x + (y - x) * w for x, y in zip(a, b))


def backdrop(height):
    """The room's colour at a height of -1 (the floor) to 1."""
    horizon, zenith, floor = (0.58, 0.48, 0.42), (0.16, 0.20, 0.30), (0.26, 0.20, 0.16)
    if height < 0:
        return mix(horizon, floor, smooth(-4 * height))
    return mix(horizon, zenith, smooth(1.6 * height))


def lamp(direction, towards, half_width, half_height, softness, bar):
    """How much of a lamp is seen: 1 inside its rectangle but for the bars, 0 outside."""
    axis = unit(towards)
    across = unit(cross((0, 1, 0), axis))
    depth = dot(direction, axis)
    if depth <= 0:
        return 0.0
    x = abs(dot(direction, across)) / depth
    y = abs(dot(direction, cross(axis, across))) / depth
    outside = max(x - half_width, y - half_height)
    if bar is not None:
        outside = max(outside, bar - min(x, y))
    return smooth(0.5 - outside / (2 * softness))


def color(direction):
    d = unit(direction)
    result = backdrop(d[1])
    for towards, half_width, half_height, softness, shine, bar in LAMPS:
        result = mix(result, shine, lamp(d, towards, half_width, half_height, softness, bar))
    return bytes(round(255 * c) for c in result)


def png(rows):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    size = struct.pack(">IIBBBBB", SIZE, SIZE, 8, 2, 0, 0, 0)
    # Filter 2 (up): every row as its difference to the one above.
    above = [bytes(3 * SIZE)] + rows[:-1]
    data = b"".join(
        b"\2" + bytes((x - y) & 255 for x, y in zip(row, up)) for row, up in zip(rows, above))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", size) + chunk(b"IDAT", zlib.compress(data, 9)) +
            chunk(b"IEND", b""))


def main():
    centres = [(2 * k + 1) / SIZE - 1 for k in range(SIZE)]
    for name, direction in FACES.items():
        rows = [b"".join(color(direction(s, t)) for s in centres) for t in reversed(centres)]
        pathlib.Path(__file__).with_name(name + ".png").write_bytes(png(rows))


if __name__ == "__main__":
    main()
