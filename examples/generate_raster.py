#!/usr/bin/env python3
"""Writes a long finishing program, as a CAM system would: a ball-nose raster over a wavy surface.

The surface is the sum of two cosines,

    z(x, y) = A (cos(2 pi x / LX) - 1) + B (cos(2 pi y / LY) - 1)

with its crests at Z0. The tool touches it beside its tip, so the program holds the path of the
tip: for every point of the raster the point of contact is sought whose normal leads to the centre
of the ball. Words that did not change are left out of a block, coordinates have three decimals.

    python3 generate_raster.py                       gsk990mc/raster.nc, about 20,000 blocks
    python3 generate_raster.py --size 25 -o small.nc   a quarter of that
    python3 generate_raster.py --size 350 -o big.nc    about a million blocks

Beside NAME.nc it writes NAME.check.json: the number of feed moves, the extents of their end points,
the length of their path and the final position, worked out here from the numbers as written.
Same arguments, same bytes. Plain Python 3, no packages.
"""

import argparse
import json
import math
from pathlib import Path

A, LX = 1.5, 40.0  # height and length of the wave along X, mm
B, LY = 1.0, 25.0  # along Y
BALL = 3.0  # radius of the tool, mm
FEED, ENTRY_FEED, SPEED = 3000, 500, 6000
CLEAR, SAFE, HOME = 5.0, 50.0, 150.0  # heights above the part, mm; HOME in machine coordinates


def surface(x, y):
    """Height of the surface and its slopes along X and Y."""
    u, v = 2 * math.pi / LX, 2 * math.pi / LY
    z = A * (math.cos(u * x) - 1) + B * (math.cos(v * y) - 1)
    return z, -A * u * math.sin(u * x), -B * v * math.sin(v * y)


def tip(x, y):
    """Height of the tip of a ball that stands over (x, y) and touches the surface."""
    cx, cy = x, y
    # The ball is smaller than every hollow, so this closes in on the contact at each turn.
    for _ in range(60):
        z, p, q = surface(cx, cy)
        n = math.sqrt(1 + p * p + q * q)
        cx, cy = x + BALL * p / n, y + BALL * q / n
    z, p, q = surface(cx, cy)
    return z + BALL / math.sqrt(1 + p * p + q * q) - BALL


def word(letter, value):
    """A word without the zeros at its end: X1.25, Y0."""
    text = f"{value:.3f}".rstrip("0")
    return letter + ("0." if text in ("-0.", "0.") else text)


def raster(size, step, stepover):
    """Points of the raster, rounded to 0.001: along X there and back, row after row."""
    columns = round(size / step)
    rows = round(size / stepover)
    for row in range(rows):
        order = range(columns + 1) if row % 2 == 0 else range(columns, -1, -1)
        y = round(row * stepover, 3)
        for column in order:
            x = round(column * step, 3)
            yield x, y, round(tip(x, y), 3) + 0.0


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    lengths = [
        ("--size", 50.0, "side of the square, mm"),
        ("--step", 0.25, "step along a row, mm"),
        ("--stepover", 0.5, "from row to row, mm"),
    ]
    for name, default, text in lengths:
        options.add_argument(name, type=float, default=default, help=f"{text} (default {default:g})")
    output = Path(__file__).resolve().parent / "gsk990mc" / "raster.nc"
    options.add_argument("-o", "--output", type=Path, default=output, help="the program to write")
    args = options.parse_args()

    points = raster(args.size, args.step, args.stepover)
    x, y, z = next(points)
    blocks = [
        "O9000 (3D FINISHING, BALL NOSE OVER TWO WAVES)",
        "(WRITTEN BY GENERATE_RASTER.PY)",
        f"(STEP {args.step:g}  STEPOVER {args.stepover:g}  SQUARE OF {args.size:g})",
        "(ZERO X0 Y0 = LOWER LEFT CORNER, Z0 = CRESTS, 0.3 LEFT BY ROUGHING)",
        f"(T01 BALL NOSE D{2 * BALL:g}, MEASURED TO THE TIP)",
        "G21",
        "G17 G40 G49 G80 G90 G94 G54",
        f"G00 G53 {word('Z', HOME)}",
        "T01 M06",
        f"G00 G54 {word('X', x)} {word('Y', y)} S{SPEED} M03",
        f"G43 H01 {word('Z', SAFE)} M08",
        word("Z", CLEAR),
        f"G01 {word('Z', z)} F{ENTRY_FEED}",
    ]
    moves, length = 1, CLEAR - z
    low, high = [x, y, z], [x, y, z]
    feed = f"F{FEED}"
    for point in points:
        words = [word(a, new) for a, new, old in zip("XYZ", point, (x, y, z)) if new != old]
        length += math.dist(point, (x, y, z))
        moves += 1
        x, y, z = point
        low = [min(a, b) for a, b in zip(low, point)]
        high = [max(a, b) for a, b in zip(high, point)]
        blocks.append("".join(words) + feed)
        feed = ""
    blocks += [f"G00 {word('Z', SAFE)} M09", f"G53 {word('Z', HOME)} M05", "M30", "%"]

    args.output.write_text("\n".join(blocks) + "\n", encoding="ascii", newline="\n")
    facts = {
        "program": args.output.name,
        "blocks": len(blocks) - 1,
        "feed_moves": moves,
        "feed_mm_min": FEED,
        "path_mm": round(length, 3),
        "min": {"x": low[0], "y": low[1], "z": low[2]},
        "max": {"x": high[0], "y": high[1], "z": high[2]},
        "final": {"x": x, "y": y, "z": HOME},
    }
    check = args.output.with_suffix(".check.json")
    check.write_text(json.dumps(facts, indent=2) + "\n", encoding="ascii", newline="\n")
    print(f"{args.output}: {facts['blocks']} blocks, {moves} feed moves, {length / 1000:.3f} m")


if __name__ == "__main__":
    main()
