"""Where Ferrocut differs from LinuxCNC's interpreter on purpose. `docs/rs274-deviations.md` gives the reasons.

A row is a name, which stands in that page, and a test of a difference with its program; what it holds for
is counted apart and is no failure. What can be left out of programs is left out by the generator.
"""

import re


def line_at(program, number):
    """The line with a marked number, `N25` or `(L25)`."""
    mark = re.compile(rf"^/?N{number}\D|\(L{number}\)")
    return next((line for lines in program.files.values() for line in lines if mark.search(line)), "")


KNOWN = (
    (
        "the rest of a division by nothing is no number",
        lambda program, theirs, ours, difference: difference.kind == "alarm" and "FC-0705" in difference.text,
    ),
    (
        "a spline in feed per revolution does not ask whether the spindle turns",
        lambda program, theirs, ours, difference: "FC-0319" in difference.text
        and bool(re.search(r"G5(\D|\.[12])", line_at(program, ours.error_line))),
    ),
)


def of(program, theirs, ours, difference):
    """The name of the known deviation that a difference is, or None."""
    for name, holds in KNOWN:
        if holds(program, theirs, ours, difference):
            return name
    return None


# Samples of the package that the stand-alone program runs in another way than LinuxCNC on a machine does.
UVW = "axes U, V, W, which the stand-alone program has not"
PROBE = "probing, after which the stand-alone program stands beside the point"
CHANGE = "G43 in the block of a tool change, in which the stand-alone program loses the length"
SAMPLES = {
    "foam.ngc": UVW,
    "cone.ngc": UVW,
    "useful-subroutines.ngc": PROBE,
    "x-trim.ngc": PROBE,
    "mmount.ngc": CHANGE,
    "skeleton.ngc": CHANGE,
    "offsets.ngc": CHANGE,
}
