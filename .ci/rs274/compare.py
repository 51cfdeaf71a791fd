"""Says where two paths differ."""

import dataclasses
import math
import re

from path import NOTHING, PLANES

# mm and degrees, on every axis at every end of a move, and along every arc.
TOLERANCE = 0.0005
# Of feeds, of the value itself: traces and calls print six decimals or more.
FEED = 1e-5
# What rounding to six decimals may move the ends of a move apart, mm.
PLACES = 5e-6
# What the same rounding may make of a time, s.
SECONDS = 5e-7


@dataclasses.dataclass
class Difference:
    kind: str            # what differs: one word, by which differences are counted
    text: str
    line: int = None     # marked line of the program


def visible(moves):
    """The moves that move something. A start follows the end of the move that was before."""
    return [
        m
        for m in moves
        if m.kind in ("arc", "curve") or max(abs(a - b) for a, b in zip(m.start, m.end)) > NOTHING
    ]


def curve_length(ours, at):
    """How many of our moves from `at` on are one curve of the program: all of one line."""
    line = ours[at].line
    count = 0
    while at + count < len(ours) and ours[at + count].line == line and ours[at + count].kind in ("arc", "feed"):
        count += 1
    return count


def speed(move):
    """Feed as mm/min or mm/rev."""
    mode, value = move.feed
    if mode == "s":
        length = math.dist(move.start[:3], move.end[:3]) or math.dist(move.start, move.end)
        if move.kind == "arc":
            radius = math.dist(move.center, [move.start[i] for i in PLANES[move.plane][:2]])
            third = PLANES[move.plane][2]
            length = math.hypot(radius * move.sweep, move.end[third] - move.start[third])
        return ("f", length / value * 60.0 if value else 0.0)
    return mode, value


def move_difference(theirs, ours):
    """What differs between two moves, or None."""
    if theirs.kind != ours.kind:
        return "kind", f"{theirs.kind} became {ours.kind}"
    apart = max(abs(a - b) for a, b in zip(theirs.end, ours.end))
    if not apart <= TOLERANCE:
        return "end", f"ends {apart:.6f} apart"
    if theirs.kind == "arc":
        if theirs.plane != ours.plane:
            return "plane", f"plane {theirs.plane} became {ours.plane}"
        apart = math.dist(theirs.center, ours.center)
        if not apart <= TOLERANCE:
            return "centre", f"centres {apart:.6f} apart"
        first, second, _ = PLANES[theirs.plane]
        radius = math.hypot(theirs.end[first] - theirs.center[0], theirs.end[second] - theirs.center[1])
        apart = abs(theirs.sweep - ours.sweep) * radius
        if not apart <= 2 * TOLERANCE:
            return "sweep", f"sweeps {math.degrees(theirs.sweep):.5f}° and {math.degrees(ours.sweep):.5f}°"
    if theirs.kind == "sync" and not abs(theirs.pitch - ours.pitch) <= TOLERANCE:
        return "pitch", f"pitch {theirs.pitch:.6g} became {ours.pitch:.6g}"
    if theirs.feed and ours.feed and theirs.kind in ("feed", "arc"):
        (mode, value), (our_mode, our_value) = speed(theirs), speed(ours)
        allowed = FEED * max(1.0, abs(value))
        if ours.feed[0] == "s":
            # A speed from length and time is as good as the places of the length's ends and of the time.
            allowed += abs(value) * PLACES / max(ours.length(), PLACES)
            allowed += abs(value) * SECONDS / max(ours.feed[1], SECONDS)
        if mode != our_mode or abs(value - our_value) > allowed:
            return "feed", f"feed {mode} {value:.6g} became {our_mode} {our_value:.6g}"
    return None


def compare(theirs, ours):
    """The first difference of two paths, or None."""
    their_moves, our_moves = visible(theirs.moves), visible(ours.moves)
    i = j = 0
    while i < len(their_moves) and j < len(our_moves):
        move = their_moves[i]
        if move.kind == "curve":
            count = curve_length(our_moves, j)
            if count == 0:
                return Difference("curve", f"a curve became {our_moves[j]}", move.line)
            # What follows a curve begins where it ended, which its call does not show.
            i, j = i + 1, j + count
            continue
        found = move_difference(move, our_moves[j])
        if found:
            return Difference(found[0], f"{found[1]}\n  theirs: {move}\n  ours:   {our_moves[j]}", move.line)
        i, j = i + 1, j + 1
    left, our_left = their_moves[i:], our_moves[j:]
    # Where both stop with an error, one may have handed on more of the moves that look-ahead keeps.
    if theirs.error and not ours.error:
        return Difference("no alarm", f"theirs stops at line {theirs.error_line}: {theirs.error}; ours goes on")
    if ours.error and not theirs.error:
        return Difference("alarm", f"ours stops at line {ours.error_line}: {ours.error}; theirs goes on")
    if theirs.error:
        if theirs.error_line != ours.error_line:
            return Difference(
                "error line",
                f"theirs stops at line {theirs.error_line}: {theirs.error}\n"
                f"ours stops at line {ours.error_line}: {ours.error}",
            )
        if len(left) > LOOK_AHEAD or len(our_left) > LOOK_AHEAD:
            return Difference("moves before error", f"before the error theirs has {len(left)} and ours {len(our_left)} more moves")
        return message_difference(theirs, ours, False)
    if our_left:
        return Difference("more moves", f"ours has more: {our_left[0]}", our_left[0].line)
    if left:
        return Difference("fewer moves", f"theirs has more: {left[0]}", left[0].line)
    return event_difference(theirs, ours) or message_difference(theirs, ours, True)


def event_difference(theirs, ours):
    """What differs in dwells, tool changes and stops."""
    for a, b in zip(theirs.events, ours.events):
        if a[0] != b[0] or (a[1] != b[1] and not (isinstance(a[1], float) and abs(a[1] - b[1]) < 1e-6)):
            return Difference("event", f"{a} became {b}")
    if len(theirs.events) != len(ours.events):
        return Difference("event", f"events {theirs.events} became {ours.events}")
    return None


NUMBER = re.compile(r"[-+]?\d+\.\d+")


def message_difference(theirs, ours, whole):
    """What differs in messages: their words, and the numbers in them within 2e-6 (six decimals are shown)."""
    for a, b in zip(theirs.messages, ours.messages):
        numbers, our_numbers = NUMBER.findall(a), NUMBER.findall(b)
        same = NUMBER.sub("#", a).split() == NUMBER.sub("#", b).split() and all(
            abs(float(x) - float(y)) < 2e-6 * max(1.0, abs(float(x))) for x, y in zip(numbers, our_numbers)
        )
        if not same:
            return Difference("message", f"{a!r} became {b!r}")
    if whole and len(theirs.messages) != len(ours.messages):
        return Difference("message", f"{len(theirs.messages)} messages became {len(ours.messages)}")
    return None


# Moves that either interpreter may still hold when an error of the next line stops it.
LOOK_AHEAD = 3
