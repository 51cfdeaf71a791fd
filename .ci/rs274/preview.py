#!/usr/bin/python3
"""Prints where the curves of a program lie, by LinuxCNC's preview module: a point of mm a line.

    preview.py PROGRAM PARAMETERS

`rs274` hides the points of a spline; the preview makes chords whose ends are on the curve. The module is
in the same package and belongs to the system's own Python, whatever other there is.
"""

import sys

import gcode

INCH = 25.4


class Canon:
    """Takes what the preview calls, and shows the ends of its moves."""

    def __init__(self, parameters):
        self.parameter_file = parameters

    def straight_feed(self, x, y, z, *_):
        print(f"feed {x * INCH:.9f} {y * INCH:.9f} {z * INCH:.9f}")

    def straight_traverse(self, x, y, z, *_):
        print(f"rapid {x * INCH:.9f} {y * INCH:.9f} {z * INCH:.9f}")

    def get_external_angular_units(self):
        return 1.0

    def get_external_length_units(self):
        return 1.0

    def get_axis_mask(self):
        return 63

    def get_block_delete(self):
        return 0

    def check_abort(self):
        return 0

    def get_tool(self, _):
        return (-1, *[0.0] * 12, 0)

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return lambda *_: 0


result, line = gcode.parse(sys.argv[1], Canon(sys.argv[2]), "G21", "")
sys.exit(0 if result <= gcode.MIN_ERROR else f"line {line}: {gcode.strerror(result)}")
