#!/usr/bin/env python3
"""Random programs through LinuxCNC's `rs274` and through Ferrocut: every motion and every error must agree.

    differential.py BINARY [--legal 2000] [--first SEED] [--seed SEED] [--minimise FOLDER] [-v]

Programs are drawn until so many of them run to their end in LinuxCNC; those with an error are compared as
well. A program is a seed: `--seed` shows one with both paths. `--minimise` writes the smallest programs
that still differ into a folder, one of each kind of difference.
"""

import argparse
import collections
import itertools
import multiprocessing
import os
import pathlib
import re
import sys
import tempfile

import canon
import compare
import deviations
import generate
import oracle
import steps

AT_ONCE = 200
# What alarms say of words that the dialect leaves out.
NOT_CARRIED = ("does not carry", "write no files")
SOUGHT = re.compile(r"EOF in file:(\S+) seeking o-word: \S+ from line: (\d+)")


class Bench:
    """A folder of this process, in which one program at a time is written and run by both."""

    def __init__(self, folder, theirs, ours):
        self.folder = pathlib.Path(folder) / f"process-{os.getpid()}"
        (self.folder / "home").mkdir(parents=True, exist_ok=True)
        self.theirs, self.ours = theirs, ours

    def write(self, program):
        for old in self.folder.glob("*.ngc"):
            old.unlink()
        for name, lines in program.files.items():
            (self.folder / name).write_text("\n".join(lines) + "\n")
        (self.folder / "tools.tbl").write_text(program.tools)
        (self.folder / "parameters.var").write_text(program.parameters)

    def run(self, program):
        """Both paths."""
        self.write(program)
        main, tools, parameters = (self.folder / name for name in ("main.ngc", "tools.tbl", "parameters.var"))
        answer = oracle.run(self.theirs, main, self.folder / "home", tools, parameters, seconds=20)

        def marks(file, line):
            lines = program.files.get(pathlib.Path(file or "main.ngc").name, [])
            return oracle.line_of(lines[line - 1]) if line and line <= len(lines) else None

        theirs = canon.read(answer, program.tools)
        sought = SOUGHT.search(theirs.error or "")
        if sought:
            # It looks for a subprogram to the end of the file and shows the line there; the call is at fault.
            theirs.error_line = marks(sought.group(1), int(sought.group(2)))
        return theirs, steps.run(self.ours, main, tools, parameters, 20, marks)


def judge(bench, program):
    """What is found for one program: (legal, difference or None, name of the known deviation or None)."""
    theirs, ours = bench.run(program)
    difference = compare.compare(theirs, ours)
    known = deviations.of(program, theirs, ours, difference) if difference else None
    return theirs.error is None, difference, known, len(theirs.moves)


def smaller(bench, program, difference):
    """The program with every line left out without which the same kind of difference remains."""

    def still(candidate):
        try:
            _, found, known, _ = judge(bench, candidate)
        except Exception:
            return False
        return found and not known and signature(found) == signature(difference)

    def without(name, begin, end):
        files = {n: list(lines) for n, lines in program.files.items()}
        del files[name][begin:end]
        return generate.Program(program.seed, files, program.tools, program.parameters, program.fault)

    for name in list(program.files):
        size = max(1, len(program.files[name]) // 2)
        while size >= 1:
            begin = 0
            while begin < len(program.files[name]):
                candidate = without(name, begin, begin + size)
                if still(candidate):
                    program = candidate
                else:
                    begin += size
            size //= 2
    return program


def signature(difference):
    """What makes two differences one: their kind, and for alarms the texts."""
    if difference.kind in ("alarm", "no alarm", "error line"):
        said = [line.split(": ", 1)[-1] for line in difference.text.split("\n")]
        # A word that is not carried is one thing, wherever the other stops.
        said = [text for text in said if any(words in text for words in NOT_CARRIED)] or said
        plain = ["".join("#" if c.isdigit() else c for c in text.split("; theirs")[0].split("; ours")[0]) for text in said]
        return difference.kind, " / ".join(" ".join(text.split()[:7]) for text in plain)
    if difference.kind == "kind":
        return difference.kind, difference.text.split("\n")[0]
    return difference.kind, ""


def show(program, difference, theirs, ours):
    """A text about one difference: the program, its tables and both paths."""
    parts = [f"seed {program.seed}: {difference.kind}: {difference.text}"]
    if program.fault:
        parts.append(f"fault put in: {program.fault}")
    for name, lines in program.files.items():
        if lines:
            parts.append(f"--- {name}\n" + "\n".join(lines))
    parts.append("--- tools (mm)\n" + program.tools + "--- parameters (mm)\n" + program.parameters)
    for title, path in (("theirs", theirs), ("ours", ours)):
        moves = compare.visible(path.moves)
        parts.append(f"--- {title}\n" + "\n".join(map(str, moves[:40])))
        if path.messages:
            parts.append(f"messages: {path.messages[:10]}")
        if path.error:
            parts.append(f"stops at line {path.error_line}: {path.error}")
    return "\n".join(parts) + "\n"


def work(seed):
    program = generate.program(seed)
    return (seed, *judge(BENCH, program))


def begin(folder, theirs, ours):
    global BENCH
    BENCH = Bench(folder, theirs, ours)


def main():
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("binary")
    asked.add_argument("--legal", type=int, default=2000, help="how many programs without an error to draw")
    asked.add_argument("--first", type=int, default=1, help="first seed")
    asked.add_argument("--seed", type=int, help="show this program alone")
    asked.add_argument("--minimise", help="folder for the smallest programs that differ")
    asked.add_argument("-v", "--verbose", action="store_true", help="show every difference")
    arguments = asked.parse_args()
    ours = pathlib.Path(arguments.binary).resolve()
    with tempfile.TemporaryDirectory(prefix="rs274-") as folder:
        try:
            name, theirs = oracle.installed(), oracle.precise_copy(folder)
        except oracle.NotUsable as why:
            print(f"left out: {why}")
            return 0
        if arguments.seed is not None:
            return one(arguments.seed, Bench(folder, theirs, ours), arguments.minimise)
        return many(arguments, name, folder, theirs, ours)


def one(seed, bench, minimise):
    program = generate.program(seed)
    _, difference, known, _ = judge(bench, program)
    if difference and minimise:
        program = smaller(bench, program, difference)
    theirs, ours = bench.run(program)
    difference = compare.compare(theirs, ours) or compare.Difference("none", f"they agree{f' ({known})' if known else ''}")
    print(show(program, difference, theirs, ours))
    return 0 if difference.kind == "none" or known else 1


def many(arguments, name, folder, theirs, ours):
    legal = illegal = moves = 0
    failed, known = [], collections.Counter()
    seeds = itertools.count(arguments.first)
    with multiprocessing.Pool(os.cpu_count(), begin, (folder, theirs, ours)) as pool:
        while legal < arguments.legal:
            for seed, ok, difference, deviation, count in pool.imap(work, itertools.islice(seeds, AT_ONCE), chunksize=4):
                legal, illegal, moves = legal + ok, illegal + (not ok), moves + count
                if deviation:
                    known[deviation] += 1
                elif difference:
                    failed.append((seed, difference))
    print(f"{name}: {legal} legal programs and {illegal} with an error, {moves} moves")
    for deviation, count in known.most_common():
        print(f"  known deviation, {count} times: {deviation}")
    kinds = collections.defaultdict(list)
    for seed, difference in failed:
        kinds[signature(difference)].append((seed, difference))
    for kind, cases in sorted(kinds.items(), key=lambda item: -len(item[1])):
        print(f"  {len(cases):5} {kind[0]} {kind[1]}: seeds {' '.join(str(seed) for seed, _ in cases[:6])}")
        if arguments.verbose:
            print("        " + cases[0][1].text.replace("\n", "\n        "))
    if arguments.minimise:
        bench = Bench(folder, theirs, ours)
        target = pathlib.Path(arguments.minimise)
        target.mkdir(parents=True, exist_ok=True)
        for number, (kind, cases) in enumerate(sorted(kinds.items(), key=lambda item: -len(item[1])), 1):
            seed, difference = cases[0]
            program = smaller(bench, generate.program(seed), difference)
            both = bench.run(program)
            found = compare.compare(*both) or difference
            word = "-".join(w for w in f"{kind[0]} {kind[1]}".lower().replace("/", " ").split() if w.isalnum())[:50]
            (target / f"{number:03}-{word}.txt").write_text(f"{len(cases)} of {legal + illegal} programs\n" + show(program, found, *both))
    print(f"{len(failed)} programs differ" if failed else "every motion and every error agrees")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
