"""Motions, as both interpreters' outputs are read: one list of moves in machine coordinates, mm and degrees."""

import dataclasses
import math

AXES = "xyzabc"
# First and second axis of each plane, and the third.
PLANES = {"xy": (0, 1, 2), "yz": (1, 2, 0), "zx": (2, 0, 1)}

# A move by less is none, mm and degrees. Traces leave out less than 1e-6.
NOTHING = 5e-6


@dataclasses.dataclass(slots=True)
class Move:
    kind: str                 # rapid, feed, arc, sync (with the spindle), probe, curve
    start: tuple              # of XYZABC
    end: tuple
    line: int                 # marked line that caused it; with cutter compensation the last line read
    plane: str = ""
    center: tuple = ()
    sweep: float = 0.0        # radians, counter-clockwise positive
    feed: object = None       # ("f", mm/min), ("frev", mm/rev), ("s", seconds); None where it is not judged
    pitch: float = 0.0        # mm a revolution of a sync move

    def length(self):
        return math.dist(self.start, self.end)

    def __str__(self):
        moved = " ".join(
            f"{name}{to:.6g}" for name, was, to in zip(AXES, self.start, self.end) if abs(was - to) > 5e-7
        )
        more = ""
        if self.kind == "arc":
            more = f" {self.plane} centre {self.center[0]:.6f},{self.center[1]:.6f} sweep {math.degrees(self.sweep):.5f}"
        if self.kind == "sync":
            more = f" pitch {self.pitch:.6g}"
        return f"{self.line or '?':>5} {self.kind:5} {moved}{more}"


@dataclasses.dataclass
class Path:
    moves: list
    error: str = None         # message or alarm
    error_line: int = None
    events: list = dataclasses.field(default_factory=list)
    messages: list = dataclasses.field(default_factory=list)
