#!/usr/bin/env python3
"""Random splines G5, G5.1 and G5.2: the path must hold every point that LinuxCNC's preview puts on them.

    curves.py BINARY [--programs 150]

Ours are arcs within a tolerance of the curve; theirs are points of the curve itself.
"""

import argparse
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

import oracle
import steps

PYTHON = "/usr/bin/python3"
# Distance of our path from the curve, mm: the tolerance of the fit (`crates/geometry`), and what the
# comparison of positions allows.
TOLERANCE = 0.001 + 0.0005


def program(seed):
    """Lines of a program with one or two curves, in mm and absolute."""
    rng = random.Random(seed)

    def words(letters):
        return " ".join(f"{letter}{rng.uniform(-30, 30):.3f}" for letter in letters)

    lines = ["G21 G90 G17 G94", f"G0 {words('XYZ')}", "G1 F500 X1 Y1"]
    kind = rng.choice(("G5", "G5.1", "G5.2"))
    if kind == "G5":
        lines.append(f"G5 {words('XYIJPQ')}")
        lines += [f"G5 {words('XYPQ')}"] * rng.randint(0, 1)
    elif kind == "G5.1":
        lines.append(f"G5.1 {words('XYIJ')}")
    else:
        order = rng.choice((3, 3, 4))
        lines.append(f"G5.2 {words('XY')} P{rng.choice((1, 1, 0.5, 3))} L{order}")
        for _ in range(rng.randint(order - 1, 7)):
            lines.append(f"{words('XY')} P{rng.choice((1, 1, 0.5, 2.5))}")
        lines.append("G5.3")
    return [*lines, "M2"]


def distance(point, move):
    """Of a point in XY from a straight move or an arc."""
    x, y = point
    (ax, ay), (bx, by) = move.start[:2], move.end[:2]
    if move.kind == "arc":
        cx, cy = move.center
        angle = math.atan2(y - cy, x - cx)
        begin = math.atan2(ay - cy, ax - cx)
        turned = (angle - begin) % math.tau if move.sweep > 0 else (begin - angle) % math.tau
        if turned <= abs(move.sweep):
            return abs(math.hypot(x - cx, y - cy) - math.hypot(ax - cx, ay - cy))
    else:
        length = math.hypot(bx - ax, by - ay)
        if length > 0:
            t = ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length**2
            if 0 <= t <= 1:
                return abs((x - ax) * (by - ay) - (y - ay) * (bx - ax)) / length
    return min(math.hypot(x - ax, y - ay), math.hypot(x - bx, y - by))


def judge(seed, ours, folder):
    """What is wrong with a program's curves, or None; and the largest distance."""
    path = folder / "curve.ngc"
    path.write_text("\n".join(program(seed)) + "\n")
    parameters = folder / "parameters.var"
    parameters.write_text("".join(f"{n}\t0.0\n" for n in range(5161, 5167)) + "5220\t1.0\n")
    asked = subprocess.run(
        [PYTHON, str(pathlib.Path(__file__).with_name("preview.py")), str(path), str(parameters)],
        env={**os.environ, "HOME": str(folder)}, capture_output=True, text=True,
    )  # fmt: skip
    if asked.returncode:
        return f"the preview failed: {asked.stderr[-200:]}", 0.0
    points = [tuple(map(float, line.split()[1:])) for line in asked.stdout.splitlines() if line.startswith("feed")]
    own = steps.run(ours, path)
    if own.error:
        return own.error, 0.0
    moves = [m for m in own.moves if m.kind in ("arc", "feed")]
    if not moves or math.dist(moves[-1].end[:3], points[-1]) > 0.0005:
        return f"ends at {moves[-1].end[:3] if moves else None}, not {points[-1]}", 0.0
    if not any(m.kind == "arc" for m in moves):
        return "no arcs: chords of a curve are visible", 0.0
    worst = 0.0
    # Both run the same way along: the search goes on where the last point was found.
    at = 0
    for point in points:
        # The first that holds it: a curve may come by the same place again.
        holds = (i for i in range(at, len(moves)) if distance(point[:2], moves[i]) <= TOLERANCE)
        near = next(holds, None)
        if near is None:
            near = min(range(at, len(moves)), key=lambda i: distance(point[:2], moves[i]))
        worst = max(worst, distance(point[:2], moves[near]))
        at = max(at, near - 2)
    # And ours goes nowhere else: its joints are near the chords of the curve.
    for move in moves:
        x, y = move.end[:2]
        apart = min(
            math.dist((x, y), a[:2]) + math.dist((x, y), b[:2]) - math.dist(a[:2], b[:2])
            for a, b in zip(points, points[1:])
        )
        if apart > 0.5:
            return f"goes through {x:.4f}, {y:.4f}, {apart:.4f} off the curve", worst
    return (f"{worst:.6f} mm from a point of the curve" if worst > TOLERANCE else None), worst


def main():
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("binary")
    asked.add_argument("--programs", type=int, default=150)
    arguments = asked.parse_args()
    ours = pathlib.Path(arguments.binary).resolve()
    try:
        name = oracle.installed()
    except oracle.NotUsable as why:
        print(f"left out: {why}")
        return 0
    failed, worst = 0, 0.0
    with tempfile.TemporaryDirectory(prefix="rs274-") as folder:
        for seed in range(arguments.programs):
            wrong, apart = judge(seed, ours, pathlib.Path(folder))
            worst = max(worst, apart)
            if wrong:
                failed += 1
                print(f"  seed {seed}: {wrong}\n    " + "\n    ".join(program(seed)))
    print(f"{name}: {arguments.programs} programs with splines, {failed} wrong, at most {worst:.6f} mm off the curve")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
