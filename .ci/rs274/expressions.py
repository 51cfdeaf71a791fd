"""Random expressions of RS274/NGC with the values that they have, so that programs stay within bounds.

What both interpreters make of an expression is compared through the positions that it leads to. A value
near a jump (of FIX, of a comparison) is avoided unless its operands are written numbers, because the last
bit of a sine decides nothing in a shop.
"""

import math

UNARY = ("ABS", "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN", "EXP", "LN", "SQRT", "FIX", "FUP", "ROUND")
# Operators by precedence, tightest first; each level from left to right.
LEVELS = (("**",), ("*", "/", "MOD"), ("+", "-"), ("EQ", "NE", "GT", "GE", "LT", "LE"), ("AND", "OR", "XOR"))
LEVEL = {op: i for i, level in enumerate(LEVELS) for op in level}
# Two numbers that differ by less are equal to the interpreter.
EQUAL = 0.0001


class Undefined(Exception):
    """The value is not defined, or too near to a jump, or too large."""


def unary(name, v, exact):
    if name in ("FIX", "FUP", "ROUND"):
        jump = v if name != "ROUND" else v + 0.5
        if not exact and abs(jump - round(jump)) < 1e-6:
            raise Undefined
        if name == "FIX":
            return float(math.floor(v))
        if name == "FUP":
            return float(math.ceil(v))
        return float(math.copysign(math.floor(abs(v) + 0.5), v))
    if name == "ABS":
        return abs(v)
    if name in ("SIN", "COS", "TAN"):
        value = getattr(math, name.lower())(math.radians(v))
        if name == "TAN" and abs(value) > 20:
            raise Undefined
        return value
    if name in ("ASIN", "ACOS"):
        # Near ±1 the last bit of the argument moves the result visibly.
        if abs(v) > 0.999 and not (exact and abs(v) == 1.0):
            raise Undefined
        return math.degrees(getattr(math, name.lower())(v))
    if name == "EXP":
        if v > 6:
            raise Undefined
        return math.exp(v)
    if v < 1e-3:
        raise Undefined
    return math.log(v) if name == "LN" else math.sqrt(v)


def binary(op, a, b, exact):
    if op in ("EQ", "NE", "GT", "GE", "LT", "LE"):
        if abs(abs(a - b) - EQUAL) < 1e-7 or (not exact and abs(a - b) < 2 * EQUAL):
            raise Undefined
        same = abs(a - b) < EQUAL
        truth = {"EQ": same, "NE": not same, "GT": a > b, "GE": a >= b, "LT": a < b, "LE": a <= b}
        return float(truth[op])
    if op in ("AND", "OR", "XOR"):
        x, y = a != 0.0, b != 0.0
        if not exact and (0 < abs(a) < 1e-6 or 0 < abs(b) < 1e-6):
            raise Undefined
        return float({"AND": x and y, "OR": x or y, "XOR": x != y}[op])
    if op == "**":
        if abs(a) < 1e-3 or abs(b) > 4 or (a < 0 and b != round(b)) or (a < 0 and not exact):
            raise Undefined
        return a**b
    if op == "/":
        if abs(b) < 0.01:
            raise Undefined
        return a / b
    if op == "MOD":
        if abs(b) < 0.01:
            raise Undefined
        rest = math.fmod(a, b)
        if not exact and min(abs(rest), abs(abs(rest) - abs(b))) < 1e-6:
            raise Undefined
        return rest + abs(b) if rest < 0 else rest
    return {"+": a + b, "-": a - b, "*": a * b}[op]


class Maker:
    """Makes expressions over the parameters in `values`, name to value."""

    def __init__(self, rng):
        self.rng = rng
        self.values = {}

    def number(self, v=None, decimals=4):
        """A number as someone may write it, and its value."""
        rng = self.rng
        if v is None:
            v = rng.choice((0, 1, 2, 3, 5, 10, 0.5, -1)) if rng.random() < 0.3 else rng.uniform(-20, 20)
            v = round(v, rng.choice((0, 0, 1, 2, 3)))
        v = round(v, decimals)
        text = f"{v:.{decimals}f}"
        if "." in text:
            text = text.rstrip("0")
        if text.endswith("."):
            text = rng.choice((text[:-1], text[:-1], text, text + "0"))
        if text in ("-0", "-0.", "-0.0"):
            text = "0"
        if text.startswith(("0.", "-0.")) and len(text.split(".")[1]) and rng.random() < 0.3:
            text = text.replace("0.", ".", 1)
        if v > 0 and rng.random() < 0.05:
            text = "+" + text
        return text, float(v)

    def case(self, word):
        return self.rng.choice((word, word.lower()))

    def parameter(self):
        """A parameter that has a value: how it is read, and that value."""
        name = self.rng.choice(sorted(self.values))
        text = name
        if name[1:].isdigit() and self.rng.random() < 0.2:
            less = self.rng.randint(1, 5)
            text = f"#[{int(name[1:]) - less}+{less}]"
        return text, self.values[name]

    def atom(self, depth):
        """(text, value, whether the value is exact to the last bit)."""
        rng = self.rng
        roll = rng.random()
        if self.values and roll < 0.3:
            text, value = self.parameter()
            if rng.random() < 0.1:
                return f"-{text}", -value, False
            return text, value, False
        if depth > 0 and roll < 0.55:
            text, value, exact = self.chain(depth - 1)
            if rng.random() < 0.1:
                return f"-[{text}]", -value, exact
            return f"[{text}]", value, exact
        if depth > 0 and roll < 0.85:
            name = rng.choice(UNARY)
            if name == "ATAN":
                a, x, _ = self.chain(depth - 1)
                b, y, _ = self.chain(depth - 1)
                if math.hypot(x, y) < 1e-3:
                    raise Undefined
                value = math.degrees(math.atan2(x, y))
                if abs(abs(value) - 180) < 1e-3:
                    raise Undefined
                return f"{self.case(name)}[{a}]/[{b}]", value, False
            text, value, exact = self.chain(depth - 1)
            return f"{self.case(name)}[{text}]", unary(name, value, exact), exact and name in ("ABS", "FIX", "FUP", "ROUND")
        text, value = self.number()
        return text, value, True

    def chain(self, depth):
        """Operands with operators between them, evaluated by precedence."""
        rng = self.rng
        operands = [self.atom(depth)]
        operators = []
        while rng.random() < 0.45 and len(operators) < 4:
            pool = rng.choice((("+", "-"), ("+", "-", "*", "/"), ("**", "MOD", "*"), LEVELS[3], LEVELS[4]))
            operators.append(rng.choice(pool))
            operands.append(self.atom(depth))
        space = rng.choice(("", " "))
        text = operands[0][0]
        for op, operand in zip(operators, operands[1:]):
            between = space if op in "+-*/**" else " "
            text += f"{between}{self.case(op)}{between}{operand[0]}"
        values = [(v, e) for _, v, e in operands]
        for level in range(len(LEVELS)):
            i = 0
            while i < len(operators):
                if LEVEL[operators[i]] == level:
                    (a, ea), (b, eb) = values[i], values[i + 1]
                    value = binary(operators[i], a, b, ea and eb)
                    # Sums of written decimals are not exact in binary: only what is a whole number counts.
                    whole = ea and eb and a == round(a) and b == round(b) and value == round(value)
                    values[i : i + 2] = [(value, whole or level > 2)]
                    operators.pop(i)
                else:
                    i += 1
        value, exact = values[0]
        if not abs(value) < 1e4:
            raise Undefined
        return text, value, exact

    def make(self, bound=1e4, depth=2):
        """An expression without its brackets and its value, within ±bound."""
        for _ in range(40):
            try:
                text, value, _ = self.chain(depth)
            except (Undefined, OverflowError, ZeroDivisionError):
                continue
            if abs(value) <= bound and len(text) < 120:
                return text, value
        text, value = self.number(self.rng.randint(-5, 5))
        return text, value

    def of(self, value, decimals=4):
        """A value that is to be met, written in one of many ways."""
        rng = self.rng
        roll = rng.random()
        if roll < 0.82:
            return self.number(value, decimals)[0]
        part = round(rng.uniform(-20, 20), 2)
        if roll < 0.88:
            return f"[{self.number(value - part, decimals)[0]} + {self.number(part)[0]}]".replace("+ +", "+ ")
        if roll < 0.94:
            name = rng.choice(sorted(self.values)) if self.values else None
            if name and abs(self.values[name]) < 1000:
                # The parameter's share is taken away again, whatever it is.
                return f"[{name} - {name} + {self.number(value, decimals)[0]}]".replace("+ +", "+ ")
        return f"[{self.number(value * 2, decimals)[0]}/2]"
