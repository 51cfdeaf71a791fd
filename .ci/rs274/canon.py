"""Reads canonical calls: programmed points to machine coordinates.

A point of a call is in the units then in force, before rotation and offsets. The machine stands at
`Rz(rotation)·(point + G92) + work offset + tool offset`. All is kept in mm and degrees.
"""

import math
import re

import oracle
from path import NOTHING, PLANES, Move, Path

CALL = re.compile(r"\s*(\d+) N(\.{5}|\d+)\s+([A-Z0-9_.]+)\((.*)\)\s*$")
POCKET = re.compile(r"^T(\d+) P(\d+)", re.MULTILINE)
# Angles that are this close, in radians, are one: emccanon's own bound for a full circle.
FULL_CIRCLE = 1e-6
MM = {"CANON_UNITS_MM": 1.0, "CANON_UNITS_INCHES": 25.4}
CANON_PLANES = {"CANON_PLANE_XY": "xy", "CANON_PLANE_YZ": "yz", "CANON_PLANE_XZ": "zx"}


class Reader:
    def __init__(self, pockets):
        self.pockets = pockets
        self.units = 1.0
        self.work = (0.0,) * 6
        self.g92 = (0.0,) * 6
        self.tool = (0.0,) * 6
        self.rotation = (1.0, 0.0)  # cosine, sine
        self.plane = "xy"
        self.feed = (0.0, 1.0)      # as programmed, and the units then in force
        self.feed_mode = "f"
        self.pitch = None           # of moves with the spindle, mm
        self.spindle = "off"
        self.at = (0.0,) * 6
        self.path = Path([])

    def machine(self, point):
        """Machine position, mm and degrees, of a point in program units."""
        k = self.units
        x, y, z, a, b, c = (
            p * (k if i < 3 else 1.0) + g for i, (p, g) in enumerate(zip(point, self.g92))
        )
        cos, sin = self.rotation
        turned = (x * cos - y * sin, x * sin + y * cos, z, a, b, c)
        return tuple(p + w + t for p, w, t in zip(turned, self.work, self.tool))

    def offset(self, values):
        return tuple(v * (self.units if i < 3 else 1.0) for i, v in enumerate(values))

    def move(self, kind, end, line, **more):
        move = Move(kind, self.at, end, line, **more)
        if kind in ("feed", "arc"):
            # Where rotary axes move alone the number is degrees, whatever the units of length.
            linear = kind == "arc" or math.dist(self.at[:3], end[:3]) > NOTHING
            value, units = self.feed
            move.feed = (self.feed_mode, value * (units if linear else 1.0))
        self.path.moves.append(move)
        self.at = end

    def arc(self, values, line):
        first, second, center_1, center_2, turns, third, *rotary = values
        turns = int(turns)
        axis = PLANES[self.plane]
        point = [0.0] * 3 + rotary
        point[axis[0]], point[axis[1]], point[axis[2]] = first, second, third
        middle = list(point)
        middle[axis[0]], middle[axis[1]] = center_1, center_2
        end, center = self.machine(point), self.machine(middle)
        center = (center[axis[0]], center[axis[1]])
        before = math.atan2(self.at[axis[1]] - center[1], self.at[axis[0]] - center[0])
        after = math.atan2(end[axis[1]] - center[1], end[axis[0]] - center[0])
        turn = math.copysign(math.tau, turns)
        sweep = math.fmod(after - before, math.tau)
        if turns > 0:
            while sweep < FULL_CIRCLE:
                sweep += math.tau
        else:
            while sweep > -FULL_CIRCLE:
                sweep -= math.tau
        sweep += turn * (abs(turns) - 1)
        self.move("arc", end, line, plane=self.plane, center=center, sweep=sweep)

    def call(self, name, text, line):
        values = None
        if name in NUMBERS:
            values = [float(v) for v in re.split(r"[,\s]+", text.strip()) if v]
        match name:
            case "STRAIGHT_TRAVERSE":
                self.move("rapid", self.machine(values), line)
            case "STRAIGHT_FEED" if self.pitch is not None:
                self.move("sync", self.machine(values), line, pitch=self.pitch)
            case "STRAIGHT_FEED":
                self.move("feed", self.machine(values), line)
            case "STRAIGHT_PROBE":
                self.move("probe", self.machine(values), line)
            case "ARC_FEED":
                self.arc(values, line)
            case "NURBS_FEED":
                # The call does not show its points; the end is where the next call's move begins.
                self.path.moves.append(Move("curve", self.at, self.at, line))
            case "RIGID_TAP":
                # Down with the thread, and with the spindle reversed back to where it began.
                above = self.at
                k = self.units
                rotary = tuple(p - w - g - t for p, w, g, t in zip(self.at[3:], self.work[3:], self.g92[3:], self.tool[3:]))
                self.move("sync", self.machine([*values, *rotary]), line, pitch=self.pitch)
                self.move("sync", above, line, pitch=self.pitch)
            case "START_SPEED_FEED_SYNC":
                self.pitch = values[0] * self.units
            case "STOP_SPEED_FEED_SYNCH":
                self.pitch = None
            case "USE_LENGTH_UNITS":
                self.units = MM[text]
            case "SET_G5X_OFFSET":
                self.work = self.offset(values[1:])
            case "SET_G92_OFFSET":
                self.g92 = self.offset(values)
            case "SET_XY_ROTATION":
                angle = math.radians(values[0])
                self.rotation = (math.cos(angle), math.sin(angle))
            case "USE_TOOL_LENGTH_OFFSET":
                self.tool = self.offset(values[:6])
            case "SELECT_PLANE":
                self.plane = CANON_PLANES.get(text, "xy")
            case "SET_FEED_RATE":
                # In inverse time mode too this is a speed: the interpreter multiplies by the length.
                self.feed = (values[0], self.units)
            case "SET_FEED_MODE":
                self.feed_mode = "frev" if values[1] else "f"
            case "DWELL" if values[0] > 0:
                self.path.events.append(("dwell", values[0]))
            case "CHANGE_TOOL":
                # The call names the pocket of the tool.
                self.path.events.append(("change", float(self.pockets.get(int(values[0]), values[0]))))
            case "PROGRAM_STOP":
                self.path.events.append(("stop", "M00"))
            case "MESSAGE":
                self.path.messages.append(text[1:-1])
            case _:
                return


NUMBERS = {
    "STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "STRAIGHT_PROBE", "ARC_FEED", "RIGID_TAP", "START_SPEED_FEED_SYNC",
    "SET_G5X_OFFSET", "SET_G92_OFFSET", "SET_XY_ROTATION", "USE_TOOL_LENGTH_OFFSET", "SET_FEED_RATE",
    "SET_FEED_MODE", "DWELL", "CHANGE_TOOL",
}  # fmt: skip


def read(answer, tools=""):
    """The path of what the interpreter answered. `tools` is the text of the tool table."""
    reader = Reader({int(pocket): int(tool) for tool, pocket in POCKET.findall(tools)})
    reader.path.error = answer.error
    reader.path.error_line = oracle.line_of(answer.text) if answer.error else None
    for text in answer.calls:
        found = CALL.match(text)
        if found:
            _, word, name, arguments = found.groups()
            reader.call(name, arguments, None if word == "....." else int(word))
    return reader.path
