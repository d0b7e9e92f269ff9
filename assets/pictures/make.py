#!/usr/bin/env python3
"""Draws the pictures of this folder. Needs nothing but Python; the same pixels each time."""
import math
import random
import struct
import zlib


def write(name, columns, rows, pixel):
    """pixel(x, y) is (r, g, b) or (r, g, b, a) from 0 to 1, from the upper left."""
    alpha = len(pixel(0, 0)) == 4
    lines = bytearray()
    for y in range(rows):
        lines.append(0)
        for x in range(columns):
            lines += bytes(round(255 * min(max(part, 0), 1)) // 4 * 4 for part in pixel(x, y))
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    head = struct.pack(">IIBBBBB", columns, rows, 8, 6 if alpha else 2, 0, 0, 0)
    with open(name, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(bytes(lines), 9)) +
                   chunk(b"IEND", b""))


def noise(seed, size):
    """Smooth noise from -1 to 1 that repeats after `size` cells."""
    source = random.Random(seed)
    grid = [[source.uniform(-1, 1) for _ in range(size)] for _ in range(size)]
    def at(x, y):
        i, j = math.floor(x), math.floor(y)
        u, v = (t * t * (3 - 2 * t) for t in (x - i, y - j))
        a, b, c, d = (grid[(j + n) % size][(i + m) % size] for n in (0, 1) for m in (0, 1))
        return (a * (1 - u) + b * u) * (1 - v) + (c * (1 - u) + d * u) * v
    return at


def times(color, light):
    return tuple(part * light for part in color)


def mixed(a, b, part):
    return tuple(x + (y - x) * part for x, y in zip(a, b))


def crate():
    n, frame, grain = 128, 15, noise(1, 32)
    def plank(along, across, seed):
        return times((0.72, 0.52, 0.31), 1 + 0.13 * grain(along * 0.06 + seed, across * 0.45 + 7 * seed))
    def pixel(x, y):
        edge = min(x, y, n - 1 - x, n - 1 - y)
        slope = (x - y) / math.sqrt(2)
        if edge < frame:
            upright = min(x, n - 1 - x) < frame and min(x, n - 1 - x) <= min(y, n - 1 - y)
            color = times(plank(y, x, 3) if upright else plank(x, y, 5), 1.05)
            joint = abs(min(x, n - 1 - x) - min(y, n - 1 - y)) < 1 and edge < frame
            if edge < 2 or edge > frame - 2 or joint: color = times(color, 0.72)
            for nail in (7.5, n - 8.5):
                if any(math.hypot(x - a, y - b) < 2.2 for a, b in ((nail, 22), (nail, n - 23), (22, nail), (n - 23, nail))):
                    color = (0.3, 0.27, 0.25)
            return color
        if abs(slope) < 10:
            return times(plank((x + y) * 0.7, slope, 9), 0.72 if abs(slope) > 8.5 else 1.0)
        board, inside = divmod(x - frame, 20)
        shade = 0.62 if inside < 1.5 else 0.84
        if abs(slope) < 14 and slope > 0: shade *= 0.85
        return times(plank(y, x, 11 + board), shade)
    write("crate.png", n, n, pixel)


def bricks():
    n, rough, tone = 128, noise(2, 64), noise(3, 16)
    def pixel(x, y):
        row = y // 16
        along = (x + (16 if row % 2 else 0)) % n
        across = min(along % 32, 31 - along % 32, y % 16, 15 - y % 16)
        grit = 0.06 * rough(x * 0.5, y * 0.5)
        if along % 32 < 2 or y % 16 < 2: return times((0.78, 0.75, 0.69), 1 + grit)
        color = mixed((0.62, 0.27, 0.19), (0.74, 0.41, 0.27), 0.5 + 0.5 * tone(along // 32 * 1.0 + row * 5, row * 1.0))
        return times(color, (1 + 2 * grit) * (0.86 if y % 16 > 13 or along % 32 > 29 else 1.0))
    write("bricks.png", n, n, pixel)


def beach_ball():
    colors = [(0.90, 0.22, 0.20), (0.98, 0.97, 0.93), (0.98, 0.78, 0.16), (0.98, 0.97, 0.93), (0.16, 0.45, 0.78),
              (0.98, 0.97, 0.93)]
    def pixel(x, y):
        if min(y, 63 - y) < 6: return (0.98, 0.97, 0.93)
        turn = x / 128 * 6
        seam = min(turn % 1, 1 - turn % 1) < 0.03
        return times(colors[int(turn)], 0.86 if seam else 1.0)
    write("beach_ball.png", 128, 64, pixel)


def grass():
    n, patches, blades = 128, noise(4, 8), noise(5, 64)
    def pixel(x, y):
        part = 0.5 + 0.35 * patches(x / 16, y / 16) + 0.3 * blades(x * 0.5, y * 0.125)
        return times(mixed((0.30, 0.45, 0.18), (0.52, 0.65, 0.28), part), 1 + 0.1 * blades(x / 2 + 9, y / 4))
    write("grass.png", n, n, pixel)


def bird():
    def ellipse(x, y, cx, cy, rx, ry, turn=0.0):
        c, s = math.cos(turn), math.sin(turn)
        u, v = (x - cx) * c + (y - cy) * s, (y - cy) * c - (x - cx) * s
        return (u / rx) ** 2 + (v / ry) ** 2 < 1
    def inside(x, y):
        if ellipse(x, y, 69, 23, 2.2, 2.2): return (0.1, 0.1, 0.12)
        if 77 < x < 90 and abs(y - 27) < 4 * (90 - x) / 13: return (0.95, 0.65, 0.15)
        if ellipse(x, y, 40, 30, 19, 10, 0.35): return (0.17, 0.33, 0.55)
        if ellipse(x, y, 56, 44, 17, 10): return (0.96, 0.88, 0.72)
        if ellipse(x, y, 67, 26, 13, 12) or ellipse(x, y, 50, 38, 28, 17): return (0.29, 0.53, 0.80)
        if 4 < x < 32 and abs(y - 33 + 0.25 * (32 - x)) < 3 + 0.22 * (32 - x): return (0.21, 0.40, 0.65)
        return None
    def pixel(x, y):
        seen = [c for i in range(3) for j in range(3) if (c := inside(x + (i - 1) / 3, y + (j - 1) / 3))]
        if not seen: return (0.29, 0.53, 0.80, 0.0)
        return tuple(sum(part) / len(seen) for part in zip(*seen)) + (len(seen) / 9,)
    write("bird.png", 96, 64, pixel)


for draw in (crate, bricks, beach_ball, grass, bird):
    draw()
