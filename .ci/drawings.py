#!/usr/bin/env python3
"""Imports drawings made by ezdxf and compares the path with the true curves.

    drawings.py BINARY

Every kind of entity, in several DXF versions and units, in blocks that are nested, scaled, turned,
mirrored and in arrays. Of each drawing 10,000 points of the path must lie within the tolerance of the
curves that ezdxf itself computes, and 10,000 points of the curves within the tolerance of the path, so
that nothing is missing. At the end the time for a drawing of 100,000 entities is told.
"""
import json
import logging
import math
import pathlib
import resource
import subprocess
import sys
import tempfile

import ezdxf
import numpy as np
from ezdxf.math import Matrix44

POINTS = 10_000
# The true curves are divided this finely, mm; half the increment of the program's numbers.
FINE, INCREMENT = 1e-4, 5e-5
MM = {0: 1.0, 1: 25.4, 2: 304.8, 4: 1.0, 5: 10.0, 6: 1000.0}


def draw_all(layout, old):
    """Every entity, about 200 units wide. R12 (`old`) has neither LWPOLYLINE nor ELLIPSE nor SPLINE."""
    layout.add_line((0, 0), (40, 30), dxfattribs={"layer": "LINES"})
    layout.add_line((0, 5, 3), (40, 35, -8))
    layout.add_arc((80, 20), 15, 300, 60)
    layout.add_arc((80, 60), 12, 10, 200, dxfattribs={"extrusion": (0, 0, -1)})
    layout.add_circle((120, 20), 18, dxfattribs={"layer": "HOLES"})
    layout.add_circle((120, 20), 3)
    bulged = [(0, 60, 0, 0, 0.4), (30, 60, 0, 0, 0), (30, 80, 0, 0, -1), (0, 80, 0, 0, 0.05)]
    layout.add_polyline2d([p[:2] + p[4:] for p in bulged], format="xyb", close=True)
    layout.add_polyline3d([(0, 90, 0), (10, 95, 5), (20, 90, 9), (30, 99, -3)])
    # A tilted circle is an ellipse from above.
    layout.add_circle((160, 60, 0), 14, dxfattribs={"extrusion": (0.3, 0.2, 0.9)})
    if old:
        return
    layout.add_lwpolyline([(x + 40, y, s, e, b) for x, y, s, e, b in bulged], close=True)
    layout.add_lwpolyline([(160, 0, 0, 0, 0.2), (180, 5, 0, 0, -0.3), (190, 20)],
                          dxfattribs={"extrusion": (0, 0, -1), "elevation": 4})
    layout.add_ellipse((50, 120), (30, 10), 0.35)
    layout.add_ellipse((50, 120), (-12, 5), 0.7, 0.3, 4.0)
    layout.add_ellipse((110, 120), (0, 25), 0.05, 5.0, 2.0)
    layout.add_ellipse((160, 120), (20, 0), 0.5, 1.0, 3.0, dxfattribs={"extrusion": (0, 0, -1)})
    points = [(0, 150), (15, 190), (30, 140), (60, 185), (80, 150), (95, 170)]
    layout.add_open_spline([(x, y, 0) for x, y in points])
    layout.add_spline().set_closed([(x + 100, y, 0) for x, y in points])
    layout.add_spline().set_open_rational([(x, y + 60, 0) for x, y in points], [1, 3, 0.5, 2, 0.2, 1])
    layout.add_open_spline([(x + 100, y + 60, 0) for x, y in points], degree=5)
    layout.add_spline([(x + 200, y, 0) for x, y in points])
    tangent = layout.add_spline([(x + 200, y + 60, 0) for x, y in points])
    tangent.dxf.start_tangent, tangent.dxf.end_tangent = (0, 1, 0), (1, 1, 0)


def drawing(version, units):
    doc = ezdxf.new(version, units=units)
    for name in ("LINES", "HOLES"):
        doc.layers.add(name)
    old = version == "R12"
    part = doc.blocks.new("PART", base_point=(10, 5))
    draw_all(part, old)
    # Units of a block are told and change nothing: the scale of the insertion holds.
    if not old:
        part.block_record.dxf.units = 1
    group = doc.blocks.new("GROUP", base_point=(-20, 30))
    group.add_blockref("PART", (0, 0), dxfattribs={"rotation": 25, "xscale": 0.5, "yscale": 0.5})
    group.add_blockref("PART", (150, 0), dxfattribs={"xscale": -0.4, "yscale": 0.4, "rotation": -70})
    group.add_circle((40, 40), 10)
    model = doc.modelspace()
    draw_all(model, old)
    model.add_blockref("PART", (400, 0), dxfattribs={"xscale": 1.3, "yscale": 0.6, "rotation": 40})
    model.add_blockref("GROUP", (0, 400), dxfattribs={"xscale": 0.8, "yscale": 1.1, "rotation": 10})
    model.add_blockref("GROUP", (500, 400), dxfattribs={"extrusion": (0, 0, -1), "rotation": 33})
    array = {"column_count": 3, "row_count": 2, "column_spacing": 150, "row_spacing": 130, "rotation": 12,
             "xscale": 0.3, "yscale": 0.3}
    model.add_blockref("GROUP", (-600, 0), dxfattribs=array)
    return doc


def points_of(entity, fine):
    """A line or curve as points at most `fine` away from it in between, by formulas."""
    kind, dxf = entity.dxftype(), entity.dxf
    if kind == "LINE":
        return [dxf.start, dxf.end]
    if kind in ("ARC", "CIRCLE"):
        return list(entity.flattening(fine))
    if kind == "ELLIPSE":
        start, sweep = dxf.start_param, (dxf.end_param - dxf.start_param) % math.tau or math.tau
        count = max(16, math.ceil(sweep / math.sqrt(8 * fine / dxf.major_axis.magnitude)))
        return list(entity.vertices(start + sweep * i / count for i in range(count + 1)))
    if kind == "SPLINE":
        tool = entity.construction_tool()
        knots = tool.knots()
        # The corner cut off by a chord falls with the square of their number; 600 leave 0.02 units here.
        count = math.ceil(600 * math.sqrt(0.02 / fine))
        return list(tool.points(np.linspace(knots[tool.order - 1], knots[tool.count], count)))
    sys.exit(f"{kind} is not expected")


def curves_of(layout, doc, matrix, fine):
    """Points of all curves of a layout, blocks written out by their matrices.

    Curves are divided in their own block and then placed: a spline through points keeps its shape in
    a block that is stretched, and a block in a stretched block may be sheared.
    """
    for entity in layout:
        if entity.dxftype() == "INSERT":
            for insert in entity.multi_insert() if entity.mcount > 1 else [entity]:
                inner = insert.matrix44() @ matrix
                yield from curves_of(doc.blocks.get(insert.dxf.name), doc, inner, fine)
            continue
        for side in entity.virtual_entities() if "POLYLINE" in entity.dxftype() else [entity]:
            points = matrix.transform_vertices(points_of(side, fine))
            yield np.array([(p.x, p.y) for p in points])


def true_curves(doc, scale):
    """Polylines within FINE mm of the curves of a drawing, in mm."""
    mm = scale * MM[doc.units if doc.dxfversion > "AC1009" else 0]
    # Blocks stretch by less than twice.
    for points in curves_of(doc.modelspace(), doc, Matrix44(), FINE / mm / 2):
        yield points * mm


def path(binary, program):
    """The cuts of a program: (from, to, centre or None, sweep in radians)."""
    trace = subprocess.run([binary, "trace", program], capture_output=True, text=True, check=True).stdout
    at, cuts = {"x": 0.0, "y": 0.0, "z": 0.0}, []
    for step in map(json.loads, trace.splitlines()):
        if "to" not in step:
            continue
        before = (at["x"], at["y"])
        at.update(step["to"])
        after = (at["x"], at["y"])
        if step["op"] == "feed" and before != after:
            cuts.append((before, after, None, 0.0))
        elif step["op"] == "arc":
            cuts.append((before, after, step["center"], math.radians(step["sweep"])))
    return cuts


def on_cut(cut, t):
    (x0, y0), (x1, y1), centre, sweep = cut
    if centre is None:
        return np.column_stack([x0 + (x1 - x0) * t, y0 + (y1 - y0) * t])
    start = math.atan2(y0 - centre[1], x0 - centre[0])
    radius = math.hypot(x0 - centre[0], y0 - centre[1])
    return np.column_stack([centre[0] + radius * np.cos(start + sweep * t), centre[1] + radius * np.sin(start + sweep * t)])


def length(cut):
    (x0, y0), (x1, y1), centre, sweep = cut
    return math.hypot(x1 - x0, y1 - y0) if centre is None else abs(sweep) * math.hypot(x0 - centre[0], y0 - centre[1])


def spread(lengths):
    """POINTS places by length: the piece of each, and where in it."""
    ends = np.cumsum(lengths)
    places = (np.arange(POINTS) + 0.5) / POINTS * ends[-1]
    piece = np.minimum(np.searchsorted(ends, places), len(lengths) - 1)
    return piece, (places - (ends[piece] - lengths[piece])) / lengths[piece]


def near(points, pieces, room):
    """Distance of each point from the nearest piece; each piece is a polyline and has its box looked at first."""
    nearest = np.full(len(points), np.inf)
    for line in pieces:
        low, high = line.min(axis=0) - room, line.max(axis=0) + room
        index = np.nonzero(np.all((points >= low) & (points <= high), axis=1))[0]
        a, v = line[:-1], np.diff(line, axis=0)
        square = np.maximum((v * v).sum(axis=1), 1e-300)
        for some in np.array_split(index, max(1, len(index) * len(a) // 4_000_000)):
            if not len(some):
                continue
            w = points[some, None, :] - a
            t = np.clip((w * v).sum(axis=2) / square, 0, 1)
            off = np.sqrt((((w - t[..., None] * v)) ** 2).sum(axis=2).min(axis=1))
            nearest[some] = np.minimum(nearest[some], off)
    return nearest


def polyline(cut):
    """A cut as a polyline within FINE of it."""
    centre, sweep = cut[2], cut[3]
    if centre is None:
        return np.array([cut[0], cut[1]])
    radius = math.hypot(cut[0][0] - centre[0], cut[0][1] - centre[1])
    count = max(2, math.ceil(abs(sweep) / math.sqrt(8 * FINE / max(radius, FINE))))
    return on_cut(cut, np.linspace(0, 1, count + 1))


def compare(binary, folder, name, doc, tolerance, order, scale):
    file, program = folder / f"{name}.dxf", folder / f"{name}.nc"
    doc.saveas(file)
    options = ["--tolerance", str(tolerance), "--order", order, "--scale", str(scale), "--format", "json"]
    run = subprocess.run([binary, "import", file, "-o", program, *options], capture_output=True, text=True)
    if run.returncode:
        sys.exit(f"{name}: import ends with {run.returncode}: {run.stdout}{run.stderr}")
    # What was saved is what is compared.
    curves = list(true_curves(ezdxf.readfile(file), scale))
    cuts = path(binary, program)
    lengths = np.array([length(cut) for cut in cuts])
    piece, t = spread(lengths)
    points = np.concatenate([on_cut(cuts[p], np.array([t])) for p, t in zip(piece, t)])
    room = tolerance + FINE + 2 * INCREMENT
    there = near(points, curves, room).max()
    parts = [np.hypot(*np.diff(curve, axis=0).T) for curve in curves]
    of = np.concatenate([np.full(len(part), i) for i, part in enumerate(parts)])
    starts = np.concatenate([np.arange(len(part)) for part in parts])
    all_parts = np.concatenate(parts)
    kept = all_parts > 0
    piece, t = spread(all_parts[kept])
    of, starts = of[kept][piece], starts[kept][piece]
    points = np.array([curves[i][s] + (curves[i][s + 1] - curves[i][s]) * u for i, s, u in zip(of, starts, t)])
    back = near(points, [polyline(cut) for cut in cuts], room).max()
    drawn = all_parts.sum()
    # The reference itself is this close to the curves.
    verdict = "ok" if max(there, back) <= tolerance + FINE else "FAIL"
    print(f"{verdict:4} {name:18} tolerance {tolerance:<6} {len(curves):5} curves, {len(cuts):6} cuts; "
          f"off {there * 1000:6.2f} µm there, {back * 1000:6.2f} µm back; "
          f"length {lengths.sum():.3f} of {drawn:.3f} mm")
    return verdict == "ok"


def time_many(binary, folder, count=100_000):
    rng = np.random.default_rng(1)
    doc = ezdxf.new("R2010", units=4)
    model = doc.modelspace()
    for i, (x, y) in enumerate(rng.random((count, 2)) * 1000):
        kind = i % 5
        if kind == 0:
            model.add_line((x, y), (x + 3, y + 4))
        elif kind == 1:
            model.add_circle((x, y), 3)
        elif kind == 2:
            model.add_arc((x, y), 3, 10, 200)
        elif kind == 3:
            model.add_lwpolyline([(x, y, 0, 0, 0.5), (x + 3, y), (x + 3, y + 3)], close=True)
        else:
            model.add_ellipse((x, y), (3, 1), 0.4, 0, 5)
    file = folder / "many.dxf"
    doc.saveas(file)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([binary, "import", file, "-o", folder / "many.nc"], check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    print(f"     {count} entities ({file.stat().st_size / 1e6:.1f} MB): {cpu:.2f} s of CPU")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    logging.disable(logging.WARNING)
    binary = str(pathlib.Path(sys.argv[1]).resolve())
    cases = [
        ("R12", 0, 0.01, "shortest", 1),
        ("R2000", 4, 0.01, "shortest", 1),
        ("R2000", 4, 0.001, "as-drawn", 1),
        ("R2007", 1, 0.01, "shortest", 1),
        ("R2010", 5, 0.1, "shortest", 0.5),
        ("R2018", 2, 0.05, "as-drawn", 0.02),
    ]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        results = [
            compare(binary, folder, f"{version} unit {units} {n}", drawing(version, units), tolerance, order, scale)
            for n, (version, units, tolerance, order, scale) in enumerate(cases)
        ]
        time_many(binary, folder)
    sys.exit(0 if all(results) else 1)


main()
