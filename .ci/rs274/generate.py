"""Random part programs over all the words of the language, most of them legal, some with one fault.

`program(seed)` makes one: its files, tool table and parameters. Every line carries its number, as an N
word or in a comment `(L12)` at its end, by which errors are told apart. The generator keeps an account of
the modal state, so that arcs end on their circle and cycles stand above their hole; where it loses sight
of the position it says so, and the next arc begins with a positioning of every axis.
"""

import dataclasses
import math
import random

import expressions
import faults

INCH = 25.4


@dataclasses.dataclass
class Program:
    seed: int
    files: dict                 # name to lines, "main.ngc" first
    tools: str
    parameters: str
    fault: str = None           # which fault was put in

    def line_number(self, file, index):
        """The marked number of a line: those of further files begin at 1000, 2000 …"""
        return 1000 * list(self.files).index(file) + index + 1


@dataclasses.dataclass
class State:
    inch: bool = False
    plane: str = "17"
    absolute: bool = True
    arc_absolute: bool = False
    position: list = None       # X Y Z in program units; None: not known
    rotated: bool = False
    tool: int = 0               # in the spindle
    length: bool = False
    feed_mode: str = "94"
    fed: bool = False
    spindle: bool = False
    used_units: bool = False


AXIS = {"17": (0, 1, 2), "18": (2, 0, 1), "19": (1, 2, 0)}
LETTER = "XYZ"
CENTER = "IJK"


class Writer:
    def __init__(self, seed):
        self.rng = random.Random(seed)
        self.seed = seed
        self.lines = []
        self.files = {}
        self.state = State()
        self.maker = expressions.Maker(self.rng)
        self.labels = 100
        self.subs = []          # (call text, number of parameters)
        self.numbered = []      # subprograms of M98, which stand behind the end of the program
        self.behind = []        # their lines
        self.depth = 0
        self.do_loops = self.rng.random() < 0.5
        self.radii = {}

    # --- writing

    def line(self, *words):
        """A line of words, in any order where that does not matter, in any case and spacing."""
        self.lines.append(" ".join(w for w in words if w))

    def shuffled(self, *words):
        words = [w for w in words if w]
        if self.rng.random() < 0.25:
            self.rng.shuffle(words)
        joint = self.rng.choice((" ", " ", " ", ""))
        text = joint.join(words)
        if self.rng.random() < 0.05:
            text = text.lower()
        self.lines.append(text)

    def label(self):
        self.labels += 1
        return self.rng.choice((f"O{self.labels}", f"o<l{self.labels}>", f"O{self.labels}", f"O<Loop_{self.labels}>"))

    def chance(self, p):
        return self.rng.random() < p

    # --- numbers

    @property
    def decimals(self):
        return 6 if self.state.inch else 4

    def mm(self, low, high, places=2):
        """A length in the units in force."""
        v = self.rng.uniform(low, high)
        return round(v / INCH, places + 2) if self.state.inch else round(v, places)

    def number(self, v):
        text = f"{v:.{self.decimals}f}".rstrip("0").rstrip(".")
        return "0" if text in ("-0", "") else text

    def value(self, v):
        return self.maker.of(v, self.decimals)

    def word(self, letter, v):
        return f"{letter}{self.value(v)}"

    # --- positions

    def forget(self):
        self.state.position = None

    def place(self, low=-50, high=50):
        """A positioning of every axis in absolute mode, after which the position is known."""
        point = [self.mm(low, high) for _ in range(3)]
        self.state.absolute = True
        self.shuffled("G90", "G0", *(self.word(a, v) for a, v in zip(LETTER, point)))
        self.state.position = point

    def known(self):
        if self.state.position is None or self.depth:
            self.place()
        return self.state.position

    def toward(self, axes, point):
        """Words that go to `point` on these axes in the distance mode in force."""
        at = self.state.position
        words = []
        for axis in axes:
            v = point[axis] if self.state.absolute else point[axis] - at[axis]
            v = round(v, self.decimals)
            words.append(self.word(LETTER[axis], v))
            # What was written is where it goes, to the last decimal.
            point[axis] = v if self.state.absolute else at[axis] + v
        return words

    def feed(self):
        """The F word that a cutting line needs now, if it needs one."""
        state = self.state
        if state.feed_mode == "93":
            return f"F{self.rng.choice((1, 2, 10, 30.5))}"
        if not state.fed or self.chance(0.1):
            state.fed = True
            if state.feed_mode == "95":
                return f"F{self.rng.choice((0.05, 0.1, 0.25))}"
            return f"F{self.rng.choice((10, 25.5, 100, 250)) if state.inch else self.rng.choice((50, 100, 355.5, 1200))}"
        return ""

    # --- motion

    def lines_of(self):
        rng, state = self.rng, self.state
        for _ in range(rng.randint(1, 5)):
            cutting = self.chance(0.6)
            axes = sorted(rng.sample(range(3), rng.choice((1, 1, 2, 2, 3))))
            words = []
            span = (-60, 60) if state.absolute else (-15, 15)
            if state.position is None or self.depth or self.chance(0.15):
                for axis in axes:
                    if self.chance(0.3):
                        text, _ = self.maker.make(3 if state.inch else 80)
                        words.append(f"{LETTER[axis]}[{text}]")
                    else:
                        words.append(self.word(LETTER[axis], self.mm(*span)))
                self.forget()
            else:
                point = [self.mm(*span) if state.absolute else state.position[i] + self.mm(*span) for i in range(3)]
                words += self.toward(axes, point)
                for axis in axes:
                    state.position[axis] = point[axis]
            if self.chance(0.1):
                words.append(self.word(rng.choice("ABC"), round(rng.uniform(-400, 400), 1)))
            code = f"G{rng.choice(('', '0')) if self.chance(0.2) else ''}{1 if cutting else 0}"
            if self.chance(0.05) and not self.depth:
                # Words of other groups on the same line, which leave everything as it is.
                code += f" G{90 if state.absolute else 91} G{state.plane}" + rng.choice(("", " G40", f" G{20 if state.inch else 21}"))
            self.shuffled(code, *words, self.feed() if cutting else "")

    def arcs(self):
        rng, state = self.rng, self.state
        if state.rotated and state.plane != "17":
            self.select_plane("17")
        for _ in range(rng.randint(1, 3)):
            at = list(self.known())
            first, second, third = AXIS[state.plane]
            direction = rng.choice((2, 3))
            radius = self.mm(1, 40, 3)
            begin = math.radians(rng.uniform(0, 360))
            center = [round(at[first] - radius * math.cos(begin), self.decimals), round(at[second] - radius * math.sin(begin), self.decimals)]
            radius = math.hypot(at[first] - center[0], at[second] - center[1])
            begin = math.atan2(at[second] - center[1], at[first] - center[0])
            words = [f"G{direction}"]
            point = list(at)
            full = self.chance(0.15)
            sweep = math.radians(rng.uniform(5, 355)) * (1 if direction == 3 else -1)
            if not full:
                point[first] = round(center[0] + radius * math.cos(begin + sweep), self.decimals)
                point[second] = round(center[1] + radius * math.sin(begin + sweep), self.decimals)
            moving = [] if full else [first, second]
            if self.chance(0.3):
                moving.append(third)
                point[third] = round(at[third] + self.mm(-10, 10), self.decimals)
            words += self.toward(moving, point)
            if not full and self.chance(0.35) and 20 < math.degrees(abs(sweep)) < 340 and abs(abs(math.degrees(sweep)) - 180) > 10:
                # Rounded up, so that a half circle still reaches.
                r = math.ceil(radius * 10**self.decimals) / 10**self.decimals
                words.append(self.word("R", r if abs(sweep) < math.pi else -r))
            else:
                pairs = []
                for axis, c in ((first, center[0]), (second, center[1])):
                    v = c if state.arc_absolute else c - at[axis]
                    if not state.arc_absolute and abs(v) < 1e-9 and self.chance(0.5):
                        continue
                    pairs.append(self.word(CENTER[axis], round(v, self.decimals)))
                words += pairs
            if self.chance(0.2):
                words.append(f"P{rng.randint(1, 4)}")
            if self.chance(0.08):
                words.append(self.word(rng.choice("ABC"), round(rng.uniform(-400, 400), 1)))
            self.shuffled(*words, self.feed())
            state.position = point

    def splines(self):
        rng, state = self.rng, self.state
        if state.feed_mode == "93" or state.rotated:
            return self.lines_of()
        self.select_plane("17")
        # The oracle's call does not show the points, so a positioning follows each curve.
        self.place()
        kind = rng.choice(("G5", "G5.1", "G5.2"))
        feed = self.feed()
        if kind == "G5":
            self.line("G5", *(self.word(w, self.mm(-20, 20)) for w in "XYIJPQ"), feed)
            if self.chance(0.5):
                self.line("G5", *(self.word(w, self.mm(-20, 20)) for w in "XYPQ"))
        elif kind == "G5.1":
            self.line("G5.1", *(self.word(w, self.mm(-20, 20)) for w in "XYIJ"), feed)
        else:
            self.line(f"G5.2 P{rng.choice((1, 2))} L{rng.choice((3, 4))}", *(self.word(w, self.mm(-20, 20)) for w in "XY"), feed)
            for _ in range(rng.randint(3, 6)):
                self.line(*(self.word(w, self.mm(-20, 20)) for w in "XY"), f"P{rng.choice((0.5, 1, 2))}")
            self.line("G5.3")
        self.place()

    def contour(self):
        """Cutter compensation around a random contour; some do not go, which both must find."""
        rng, state = self.rng, self.state
        if state.feed_mode == "93" or state.rotated and self.chance(0.5):
            return self.arcs()
        self.select_plane(rng.choice(("17", "17", "17", "18")) if not state.rotated else "17")
        if self.chance(0.5):
            self.set_distance(True)
        first, second, third = AXIS[state.plane]
        side = rng.choice((41, 42))
        word, radius = self.cutter(side)
        self.known()
        unit = radius
        self.shuffled("G0", *self.toward([first, second, third], [self.mm(-20, 20) for _ in range(3)]))
        self.forget_unless_simple()
        at = self.known()
        heading = rng.uniform(0, 360)
        corners = rng.randint(2, 7)
        modest = self.chance(0.75)
        turn_sign = rng.choice((-1, 1))
        feed = self.feed()
        on = [word]
        for corner in range(corners):
            heading += turn_sign * rng.uniform(10, 100) if modest else rng.uniform(-150, 150)
            step = unit * (rng.uniform(3, 10) if modest or corner == 0 else rng.uniform(0.5, 8))
            point = list(at)
            if corner > 0 and self.chance(0.3):
                # An arc that leaves along the heading, or across it.
                bend = rng.choice((2, 3))
                r = unit * (rng.uniform(1.5, 6) if modest else rng.uniform(0.5, 4))
                normal = math.radians(heading + (90 if bend == 3 else -90) + (0 if modest else rng.uniform(-60, 60)))
                center = [round(at[first] + r * math.cos(normal), self.decimals), round(at[second] + r * math.sin(normal), self.decimals)]
                r = math.hypot(at[first] - center[0], at[second] - center[1])
                begin = math.atan2(at[second] - center[1], at[first] - center[0])
                sweep = rng.uniform(20, 170)
                angle = begin + math.radians(sweep if bend == 3 else -sweep)
                point[first] = round(center[0] + r * math.cos(angle), self.decimals)
                point[second] = round(center[1] + r * math.sin(angle), self.decimals)
                offsets = [
                    self.word(CENTER[axis], round(c if state.arc_absolute else c - at[axis], self.decimals))
                    for axis, c in ((first, center[0]), (second, center[1]))
                ]
                heading += sweep if bend == 3 else -sweep
                self.shuffled(f"G{bend}", *self.toward([first, second], point), *offsets, feed)
            else:
                point[first] = round(at[first] + step * math.cos(math.radians(heading)), self.decimals)
                point[second] = round(at[second] + step * math.sin(math.radians(heading)), self.decimals)
                axes = [first, second]
                if self.chance(0.1):
                    axes.append(third)
                    point[third] = round(at[third] + self.mm(-3, 3), self.decimals)
                code = "G0" if self.chance(0.05) and corner else "G1"
                if on and self.chance(0.5):
                    self.line(*on)
                    on = []
                self.shuffled(code, *on, *self.toward(axes, point), feed if code == "G1" else "")
                on = []
            feed = self.feed() if state.feed_mode == "93" else feed if feed and on else ""
            at = state.position = point
            if self.chance(0.05):
                self.line(rng.choice(("M8", "M9", "G4 P0.1", "S500", "M7", "M3 S200", "M5", "G61", "(a comment)", "#5=3")))
            if self.chance(0.015):
                self.line(rng.choice(faults.WITH_COMPENSATION))
        if self.chance(0.5):
            self.line("G40")
            self.shuffled(rng.choice(("G0", "G1")), *self.toward([first, second], [self.mm(-80, 80) for _ in range(3)]), self.feed())
        else:
            self.shuffled("G40", rng.choice(("G0", "G1")), *self.toward([first, second], [self.mm(-80, 80) for _ in range(3)]), self.feed())
        self.forget()

    def forget_unless_simple(self):
        self.forget()

    def cutter(self, side):
        """The word that switches compensation on, and the cutter's radius in the units in force."""
        rng, state = self.rng, self.state
        scale = INCH if state.inch else 1.0
        if self.chance(0.35):
            diameter = self.mm(0.5, 10)
            return f"G{side}.1 D{self.number(diameter)}", max(diameter, 0.02) / 2
        if self.chance(0.5) and self.radii.get(state.tool, 0):
            return f"G{side}", self.radii[state.tool] / scale
        tool = rng.choice([t for t, r in self.radii.items() if r > 0])
        return f"G{side} D{tool}", self.radii[tool] / scale

    # --- cycles

    def cycles(self):
        rng, state = self.rng, self.state
        if state.feed_mode in ("93", "95"):
            self.set_feed_mode("94")
        code = rng.choice((81, 82, 83, 73, 85, 89, 86, 88, 84, 74, 81, 83, 82))
        if code in (84, 74):
            # Elsewhere LinuxCNC 2.9 feeds to coordinates of other axes.
            self.select_plane("17")
        first, second, third = AXIS[state.plane]
        self.place(-30, 30)
        height = state.position[third]
        feed = self.feed()
        if code in (84, 74, 86, 88) or (code == 85 and self.chance(0.3)):
            direction = {84: "M3", 74: "M4"}.get(code, rng.choice(("M3", "M4")))
            self.line(direction, "S" + rng.choice(("100", "250", "1000")))
            state.spindle = True
        self.line(*(rng.choice((["G98"], ["G99"], []))))
        if self.chance(0.35):
            self.set_distance(False)
        depth = self.mm(2, 15)
        if state.absolute:
            r = round(height - self.mm(0, 8) if self.chance(0.8) else height + self.mm(0, 8), self.decimals)
            bottom = round(r - depth, self.decimals)
        else:
            r = round(self.mm(-8, 5), self.decimals)
            bottom = -depth
        words = [f"G{code}", self.word(LETTER[third], bottom), self.word("R", r)]
        if code in (82, 89, 86, 88) or code in (84, 74) and self.chance(0.3):
            words.append(f"P{rng.choice((0, 0.1, 0.5, 2))}")
        if code in (83, 73):
            words.append(self.word("Q", max(self.mm(0.5, 6), 0.01)))
        # Tapping has no repeats.
        several = code not in (84, 74) or self.chance(0.02)
        repeats = f"L{rng.randint(1, 4)}" if several and self.chance(0.25) else ""
        holes = rng.randint(1, 4)
        for hole in range(holes):
            span = (-50, 50) if state.absolute else (-10, 10)
            axes = rng.choice(([first], [second], [first, second], [first, second]))
            at = [self.word(LETTER[axis], self.mm(*span)) for axis in axes]
            if hole == 0:
                self.shuffled(*words, *at, repeats, feed)
            else:
                again = []
                if self.chance(0.2):
                    again.append(words[2])
                if self.chance(0.2):
                    again.append(words[1])
                if self.chance(0.1):
                    again.append(f"G{code}")
                self.shuffled(*at, *again, f"L{rng.randint(1, 3)}" if several and self.chance(0.1) else "")
        if self.chance(0.7):
            self.line("G80")
        self.forget()
        self.place()

    def threads(self):
        rng, state = self.rng, self.state
        if state.rotated:
            return self.lines_of()
        if state.feed_mode != "94":
            self.set_feed_mode("94")
        self.line(rng.choice(("M3", "M4")), f"S{rng.choice((100, 300))}")
        state.spindle = True
        kind = rng.choice(("G33", "G33.1", "G76", "G33.1"))
        pitch = self.number(max(self.mm(0.5, 3), 0.02))
        if kind == "G76":
            self.select_plane("18" if self.chance(0.5) else "17")
            self.place()
            z = state.position[2]
            self.set_distance(True)
            words = [
                f"P{pitch}", self.word("Z", round(z - self.mm(5, 30), self.decimals)),
                self.word("I", rng.choice((-1, 1)) * self.mm(0.5, 3)), self.word("J", self.mm(0.2, 0.5)),
                self.word("K", self.mm(0.6, 2)),
            ]  # fmt: skip
            words += [f"R{rng.choice((1, 1.5, 2))}"] * self.chance(0.6) + [f"Q{rng.choice((0, 29.5, 30))}"] * self.chance(0.6)
            words += [f"H{rng.randint(0, 3)}"] * self.chance(0.6)
            if self.chance(0.6):
                words += [f"L{rng.randint(0, 3)}", self.word("E", self.mm(0.3, 1.5))]
            self.shuffled("G76", *words)
        else:
            self.known()
            self.shuffled(kind, self.word("Z", self.mm(-20, 20)), f"K{pitch}", *([self.word("X", self.mm(-5, 5))] * (kind == "G33" and self.chance(0.3))))
        self.forget()
        self.place()

    def probes(self):
        state = self.state
        if state.feed_mode == "93":
            return self.lines_of()
        self.known()
        code = self.rng.choice(("G38.3", "G38.5"))
        axes = self.rng.sample(range(3), self.rng.randint(1, 3))
        span = (-40, 40) if state.absolute else (5, 15)
        self.shuffled(code, *(self.word(LETTER[a], self.mm(*span)) for a in axes), self.feed())
        # The oracle believes to stand a little before the target: every axis is named next.
        self.forget()
        self.place()

    # --- modes

    def select_plane(self, plane):
        if self.state.plane != plane:
            self.state.plane = plane
            self.line(f"G{plane}")

    def set_distance(self, absolute):
        if self.state.absolute != absolute:
            self.state.absolute = absolute
            self.line("G90" if absolute else "G91")

    def set_feed_mode(self, mode):
        state = self.state
        state.feed_mode = mode
        state.fed = False
        if mode == "95" and not state.spindle:
            self.line("M3 S500")
            state.spindle = True
        self.line(f"G{mode}")

    def modes(self):
        rng, state = self.rng, self.state
        match rng.randint(0, 9):
            case 0 | 1:
                if not (state.rotated and self.chance(0.8)):
                    self.select_plane(rng.choice(("17", "17", "18", "19")))
            case 2 | 3:
                self.set_distance(not state.absolute)
            case 4:
                state.arc_absolute = not state.arc_absolute
                self.line("G90.1" if state.arc_absolute else "G91.1")
            case 5:
                self.set_feed_mode(rng.choice(("93", "94", "94", "95")))
            case 6:
                self.units()
            case 7:
                self.line(rng.choice(("G61", "G61.1", "G64", "G64 P0.05", "G64 P0.1 Q0.02")))
            case 8:
                self.line(rng.choice(("M3", "M4")), f"S{rng.choice((100, 2000.5, 0))}")
                state.spindle = True
            case 9:
                self.line(rng.choice(("G4 P0.25", "G4 P[1/4]", "M7", "M8", "M9", "M0", "M1", "M48", "M49", "M50 P0", "M51 P1", "M53 P0", "M52 P1", "M60", "M19 R30", "G97 S300", "G96 D2500 S100", "G96 S50", "M62 P1", "M63 P1", "M64 P0", "M65 P0", "M67 E0 Q1.5", "M68 E0 Q[2+1]", "M66 P0 L0", "G98", "G99", "G40", "G80", "G49" if not state.length else "G40")))
                if self.lines[-1] in ("G80", "G49"):
                    self.forget()

    def units(self):
        state = self.state
        had_length = state.length
        if had_length:
            # LinuxCNC leaves the length in force in the old units: see the deviations.
            self.line("G49")
            state.length = False
        state.inch = not state.inch
        self.line("G20" if state.inch else "G21")
        state.fed = False
        self.forget()
        if had_length and state.tool and self.chance(0.7):
            self.line("G43")
            state.length = True

    # --- offsets

    def offsets(self):
        rng, state = self.rng, self.state
        some = lambda low=-30, high=30: [  # noqa: E731
            self.word(a, self.mm(low, high)) for a in rng.sample("XYZ", rng.randint(1, 3))
        ]
        if self.chance(0.1):
            rotary = [self.word(rng.choice("ABC"), round(rng.uniform(-90, 90), 1))]
        else:
            rotary = []
        match rng.randint(0, 11):
            case 0 | 1 | 2:
                system = rng.randint(0, 9)
                turn = []
                if self.chance(0.3):
                    turn = [f"R{self.value(round(rng.uniform(-180, 180), 1) if self.chance(0.7) else 0)}"]
                    self.select_plane("17")
                    state.rotated = True
                self.shuffled("G10 L2", f"P{system}", *some(), *turn, *rotary)
            case 3:
                self.shuffled("G10 L20", f"P{rng.randint(0, 9)}", *some())
            case 4 | 5:
                self.line(f"G{rng.choice(('54', '55', '56', '57', '58', '59', '59.1', '59.2', '59.3'))}")
                # Any of them may be rotated by now.
                if any("G10" in line.upper() and "R" in line.upper() for line in self.lines):
                    state.rotated = True
                    self.select_plane("17")
            case 6:
                self.shuffled("G92", *some(), *rotary)
            case 7:
                self.line(rng.choice(("G92.1", "G92.2", "G92.3", "G92.2")))
            case 8:
                self.shuffled("G52", *some())
            case 9:
                if self.chance(0.5):
                    self.place()
                    self.line(rng.choice(("G28.1", "G30.1")))
                else:
                    self.line(rng.choice(("G28", "G30")), *(some() if self.chance(0.6) else []))
            case 10:
                self.set_distance(True)
                self.shuffled("G53", rng.choice(("G0", "G1")), *some(), self.feed())
            case 11:
                return self.tool()
        self.forget()

    def tool(self):
        rng, state = self.rng, self.state
        match rng.randint(0, 8):
            case 0 | 1 | 2:
                state.tool = rng.choice(sorted(self.radii))
                if self.chance(0.3):
                    # The stand-alone program has no tool in its spindle after M61: another one follows.
                    self.line(f"M61 Q{rng.choice(sorted(self.radii))}")
                self.line(rng.choice((f"T{state.tool} M6", f"M6 T{state.tool}")))
                # The stand-alone program may forget a change of length: every axis is named next.
                self.place()
                state.spindle = False
                if state.feed_mode == "95":
                    self.set_feed_mode("94")
            case 3 | 4:
                state.length = True
                if state.tool and self.chance(0.5):
                    self.line("G43")
                else:
                    self.line(f"G43 H{rng.choice(sorted(self.radii))}")
                    # A later change of units repeats G43 of the tool in the spindle.
                    state.length = True
            case 5:
                self.shuffled("G43.1", *(self.word(a, self.mm(-20, 20)) for a in rng.sample("XYZ", rng.randint(1, 3))))
                state.length = True
            case 6:
                self.line(f"G43.2 H{rng.choice(sorted(self.radii))}")
                state.length = True
            case 7:
                self.line("G49")
                state.length = False
            case 8:
                tool = rng.choice(sorted(self.radii))
                level = rng.choice((1, 10, 11))
                words = [self.word("Z", self.mm(-30, 60))] + [self.word("X", self.mm(-3, 3))] * self.chance(0.2)
                if self.chance(0.4):
                    radius = self.mm(0.5, 5)
                    self.radii[tool] = radius * (INCH if state.inch else 1)
                    words.append(f"R{self.number(radius)}")
                self.line(f"G10 L{level} P{tool}", *words)
        self.forget()

    # --- parameters and flow

    def assignments(self):
        rng = self.rng
        for _ in range(rng.randint(1, 3)):
            name = rng.choice(("#1", "#2", "#30", "#100", "#500", "#<a>", "#<depth>", "#<_global>", "#<_g2>"))
            text, value = self.maker.make(1000, rng.randint(1, 3))
            self.line(f"{name}=[{text}]" if not text.lstrip("+-").replace(".", "").isdigit() or self.chance(0.3) else f"{name}={text}")
            self.maker.values[name] = value
        if self.chance(0.3):
            self.shows()

    def shows(self):
        rng = self.rng
        pool = sorted(self.maker.values) or ["#1"]
        if not self.depth:
            pool += [
                "#<_x>", "#<_y>", "#<_z>", "#<_a>", "#5420", "#5421", "#5422", "#<_metric>", "#<_imperial>", "#<_plane>",
                "#<_absolute>", "#<_incremental>", "#<_coord_system>", "#<_feed>", "#<_rpm>", "#<_motion_mode>",
                "#<_ccomp>", "#<_tool_offset>", "#5400", "#<_current_tool>", "#<_spindle_on>", "#<_spindle_cw>",
                "#<_inverse_time>", "#<_units_per_minute>", "#<_units_per_rev>", "#<_call_level>", "#<_ijk_absolute_mode>",
                "#<_abs_x>", "#<_abs_z>", "#<_flood>", "#<_mist>", "#5220", "#5221", "#5242", "#5401", "#5403", "#5410",
                "#5211", "#5213", "#<_speed_override>", "#<_feed_override>",
            ]  # fmt: skip
        names = [rng.choice(pool) for _ in range(rng.randint(1, 4))]
        self.line(rng.choice((f"(debug, {' '.join(names)})", f"(DEBUG,a={names[0]})", "(MSG, hello)", "(a comment)", "; a comment")))

    def condition(self):
        left, _ = self.maker.make(1000, 1)
        right, _ = self.maker.make(1000, 1)
        op = self.rng.choice(("GT", "LT", "GE", "LE", "EQ", "NE"))
        # Written so that the values are apart, or are written numbers.
        if self.chance(0.5):
            text, value = self.maker.make(100, 2)
            return f"[[{text}] {op} {self.number(round(value + self.rng.choice((-3.5, 2.5))))}]"
        a, b = self.rng.randint(-3, 3), self.rng.randint(-3, 3)
        return f"[{a} {op} {b}]" if self.chance(0.7) else f"[{a} {op} {b} AND EXISTS[#<a>]]"

    def flow(self):
        rng = self.rng
        if self.depth > 2:
            return self.lines_of()
        # `break` of a while loop ends a do loop behind it after one pass in LinuxCNC 2.9: see the deviations.
        kind = rng.choice(("if", "if", "while", "do" if self.do_loops else "while", "repeat"))
        name = self.label()
        counter = f"#<n{self.labels}>"
        self.forget()
        saved = dict(self.maker.values)
        self.depth += 1
        if kind == "if":
            self.line(f"{name} if {self.condition()}")
            self.body()
            for _ in range(rng.choice((0, 0, 1, 2))):
                self.line(f"{name} elseif {self.condition()}")
                self.body()
            if self.chance(0.5):
                self.line(f"{name} else")
                self.body()
            self.line(f"{name} endif")
        elif kind == "repeat":
            self.line(f"{name} repeat [{rng.choice(('0', '1', '2', '3', '1+1', '2.2'))}]")
            self.body()
            self.line(f"{name} endrepeat")
        else:
            self.line(f"{counter} = 0")
            passes = rng.randint(1, 4)
            self.line(f"{name} while [{counter} LT {passes}]" if kind == "while" else f"{name} do")
            self.line(f"{counter} = [{counter} + 1]")
            self.body()
            if self.chance(0.4):
                inner = self.label()
                self.line(f"{inner} if [{counter} EQ {rng.randint(1, 3)}]")
                # `continue` of a do loop disturbs repeats there, too.
                if kind == "while":
                    jumps = ("continue",) if self.do_loops else ("break", "continue")
                else:
                    jumps = ("break",)
                self.line(f"{name} {rng.choice(jumps)}")
                self.line(f"{inner} endif")
                self.body()
            self.line(f"{name} endwhile" if kind == "while" else f"{name} while [{counter} LT {passes}]")
        self.depth -= 1
        # What was assigned within may or may not have been.
        self.maker.values = {k: v for k, v in saved.items() if k in self.maker.values and self.maker.values[k] == v}
        self.forget()

    def body(self):
        """Lines that may run any number of times: they leave every mode as it is."""
        for _ in range(self.rng.randint(1, 2)):
            self.rng.choice((self.lines_of, self.lines_of, self.shows, self.guarded_arc, self.flow, self.call))()

    def guarded_arc(self):
        """An arc for any mode: in a body the modes are those before it, but nothing else is known."""
        state = self.state
        if state.plane == "17" and not state.arc_absolute:
            absolute = state.absolute
            self.place()
            state.absolute = True
            x, y, _ = state.position
            r = self.mm(2, 10)
            self.shuffled(f"G{self.rng.choice((2, 3))}", self.word("X", round(x + 2 * r, self.decimals)), self.word("Y", y), self.word("I", r), self.feed() or self.steady_feed())
            self.line("G90" if absolute else "G91")
            state.absolute = absolute
            self.forget()
        else:
            self.lines_of()

    def steady_feed(self):
        return ""

    def define_subs(self):
        rng = self.rng
        for _ in range(rng.randint(0, 2)):
            self.labels += 1
            named = self.chance(0.5)
            file = f"sub{self.labels}.ngc"
            name = f"o<sub{self.labels}>" if named else f"o{self.labels}"
            where = self.lines
            own_file = named and self.chance(0.4)
            if own_file:
                self.lines = []
            self.line(f"{name} sub")
            parameters = rng.randint(0, 3)
            if self.chance(0.15):
                # Modes that the subprogram changes come back when it returns.
                self.line("M73")
                self.line(rng.choice(("G91", "G90 F77", "G1 F60", "G64 P0.1", "G91.1")))
            saved = self.maker.values
            self.maker.values = {f"#{i + 1}": 2.0 + i for i in range(parameters)}
            self.depth += 1
            self.state.fed = True
            if parameters and self.chance(0.7):
                self.line("G1 F100" if self.chance(0.5) else "G0", *(f"{a}[#{i + 1}]" for i, a in zip(range(parameters), "XYZ")))
            self.body()
            if self.chance(0.3):
                inner = self.label()
                self.line(f"{inner} if [#1 GT 3]")
                self.line(f"{name} return", "[#1 * 2]" if self.chance(0.5) else "")
                self.line(f"{inner} endif")
                self.body()
            self.line(f"{name} endsub", "[7.5]" if self.chance(0.3) else "")
            self.depth -= 1
            self.state.fed = False
            self.maker.values = saved
            if own_file:
                if self.chance(0.5):
                    self.line("M2")
                self.files[file] = self.lines
                self.lines = where
            self.subs.append((name, parameters))

    def define_numbered(self):
        """Subprograms called with M98, which end with M99."""
        for _ in range(self.rng.choice((0, 0, 1, 2))):
            self.labels += 1
            where, self.lines = self.lines, self.behind
            self.depth += 3
            self.state.fed = True
            self.line(f"O{self.labels}")
            self.body()
            self.line("M99")
            self.depth -= 3
            self.state.fed = False
            self.lines = where
            self.numbered.append(self.labels)

    def call(self):
        if self.numbered and not self.depth and self.chance(0.5):
            if not self.state.fed and self.state.feed_mode != "93":
                self.line(f"F{self.rng.choice((80, 120))}")
                self.state.fed = True
            self.line(f"M98 P{self.rng.choice(self.numbered)}", f"L{self.rng.randint(1, 3)}" if self.chance(0.4) else "")
            return self.forget()
        if not self.subs or self.depth > 2:
            return self.lines_of()
        name, parameters = self.rng.choice(self.subs)
        if not self.state.fed and self.state.feed_mode != "93":
            self.line(f"F{self.rng.choice((80, 120))}")
            self.state.fed = True
        arguments = []
        for _ in range(parameters + self.rng.choice((0, 0, 0, 1)) if parameters else 0):
            text, _ = self.maker.make(5, 1)
            arguments.append(f"[{text}]")
        self.line(f"{name} call", *arguments)
        if self.chance(0.3):
            self.line("(debug, #<_value> #<_value_returned>)")
        self.forget()

    def saves(self):
        """M70 to M73: modes are saved, changed and restored."""
        saved = dataclasses.replace(self.state)
        if self.state.length:
            return self.lines_of()
        self.line("M70")
        if self.chance(0.15):
            self.line("M70")
            self.line("M71")
            self.line("M70")
        for _ in range(self.rng.randint(1, 3)):
            self.rng.choice((self.lines_of, self.modes))()
        self.line("M72")
        saved.spindle = self.state.spindle
        self.state = saved
        self.state.fed = False
        self.forget()
        if self.state.feed_mode != "93":
            self.line(f"F{self.rng.choice((90, 110))}")

    # --- the whole

    def tables(self):
        """Tool table and parameters, in mm."""
        rng = self.rng
        tools = []
        for number in rng.sample(range(1, 40), 4):
            diameter = round(rng.uniform(1, 12), 3)
            self.radii[number] = diameter / 2
            words = [f"T{number} P{len(tools) + 1}", f"D{diameter:+f}", f"Z{rng.uniform(-20, 80):+.3f}"]
            if self.chance(0.2):
                words.append(f"X{rng.uniform(-5, 5):+.3f} Y{rng.uniform(-5, 5):+.3f}")
            tools.append(" ".join(words) + (" ; tool" if self.chance(0.5) else ""))
        parameters = {5220: 1}
        if self.chance(0.5):
            for base in range(5221, 5321, 20):
                for i in range(3):
                    parameters[base + i] = round(rng.uniform(-40, 40), 3)
            for base in (5161, 5181):
                for i in range(3):
                    parameters[base + i] = round(rng.uniform(-40, 40), 3)
        if self.chance(0.2):
            parameters[31 + rng.randint(0, 100)] = 1.5
        return "\n".join(tools) + "\n", "".join(f"{k}\t{v:.6f}\n" for k, v in sorted(parameters.items()))

    def make(self):
        rng = self.rng
        tools, parameters = self.tables()
        self.line(rng.choice(("G21", "G21 G90 G17", "G17 G21 G40 G49 G80 G90 G94", "G20", "G21 G90 G64 P0.01")))
        self.state.inch = self.lines[-1] == "G20"
        if self.chance(0.45):
            self.define_subs()
        if self.chance(0.2):
            self.define_numbered()
        subjects = [
            (self.lines_of, 5), (self.arcs, 6), (self.modes, 6), (self.offsets, 5), (self.tool, 2), (self.contour, 5),
            (self.cycles, 4), (self.assignments, 4), (self.flow, 3), (self.call, 3), (self.shows, 1), (self.splines, 1),
            (self.threads, 1), (self.probes, 1), (self.saves, 1),
        ]  # fmt: skip
        # A program has a few subjects, not all.
        chosen = rng.sample(subjects, rng.randint(3, 7))
        pool = [subject for subject, weight in chosen for _ in range(weight)]
        for _ in range(rng.randint(4, 14)):
            rng.choice(pool)()
        fault = None
        if self.chance(0.2):
            fault = faults.put(self)
        self.line(rng.choice(("M2", "M30", "M2")))
        self.lines += self.behind
        if self.chance(0.05) and not self.behind and not fault:
            # Between percent signs no M2 is needed.
            self.lines = ["%", *self.lines[:-1], "%"]
        files = {"main.ngc": self.lines, **self.files}
        program = Program(self.seed, files, tools, parameters, fault)
        for name in files:
            program.files[name] = [mark(self.rng, text, program.line_number(name, i)) for i, text in enumerate(files[name])]
        return program


def mark(rng, text, number):
    """The line with its number, by which an error of it is known, and with what may stand on any line."""
    if text == "%":
        return text
    if text.startswith(";"):
        return f"(L{number}) {text}"
    if text[:1] in ("o", "O") and rng.random() < 0.9 or text.startswith("("):
        return f"{text} (L{number})"
    roll = rng.random()
    if roll < 0.02:
        text = f"{text} (it is a note)"
    elif roll < 0.03:
        text = f"{text} ; it is a note"
    elif roll < 0.04 and text[:1] not in ("o", "O"):
        return f"/N{number} {text}"
    return f"N{number} {text}"


def program(seed):
    """The program of a seed."""
    return Writer(seed).make()
