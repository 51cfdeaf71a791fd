#!/usr/bin/env python3
"""The sample programs of the package linuxcnc-uspace through LinuxCNC's `rs274` and through Ferrocut.

    samples.py BINARY [-v]

Each gives the same motion, or stops at the same line, or stops with an alarm that names a word which is
not carried. The package's own list says which files they are.
"""

import argparse
import collections
import pathlib
import re
import subprocess
import sys
import tempfile

import canon
import compare
import deviations
import differential
import oracle
import steps

COMMENT = re.compile(r";.*|\([^)]*\)")
ENDINGS = (".ngc", ".nc", ".tap")


def files():
    """The package's part programs."""
    listed = subprocess.run(["dpkg", "-L", "linuxcnc-uspace"], capture_output=True, text=True).stdout.splitlines()
    paths = [pathlib.Path(line) for line in listed if line.endswith(ENDINGS)]
    # Several folders are links to one.
    return sorted({path.resolve() for path in paths if path.is_file()})


def words(text):
    """A line as both may show it: without spaces, in one case."""
    return "".join((text or "").split()).lower()


def last_words(program):
    """The last line that is more than a comment."""
    lines = [line for line in program.read_text(errors="replace").splitlines() if COMMENT.sub("", line).strip()]
    return words(lines[-1]) if lines else ""


def main():
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("binary")
    asked.add_argument("-v", "--verbose", action="store_true", help="name every program with its result")
    arguments = asked.parse_args()
    with tempfile.TemporaryDirectory(prefix="rs274-") as folder:
        try:
            name, theirs = oracle.installed(), oracle.precise_copy(folder)
        except oracle.NotUsable as why:
            print(f"left out: {why}")
            return 0
        return run(arguments, name, theirs, pathlib.Path(folder))


def run(arguments, name, theirs, folder):
    tools = folder / "tools.tbl"
    tools.write_text("".join(f"T{i} P{i} D{1 + i / 2} Z{10 + i}\n" for i in range(1, 60)))
    ours = pathlib.Path(arguments.binary).resolve()
    results = collections.Counter()
    failed = []
    for program in files():
        result, text = judge(program, theirs, ours, tools, folder)
        results[result] += 1
        if result == "differs":
            failed.append(f"{program}: {text}")
        if arguments.verbose:
            print(f"{result:32} {program} {text}")
    print(f"{name}: {sum(results.values())} sample programs: " + ", ".join(f"{n} {what}" for what, n in results.most_common()))
    for line in failed:
        print(f"  {line}")
    return 1 if failed else 0


def judge(program, theirs, ours, tools, folder):
    """What became of a sample, and a word about it."""
    answer = oracle.run(theirs, program, folder, tools)
    their_path = canon.read(answer, tools.read_text())
    where = {}

    def marks(file, line):
        """The text of the line, which is what the other program shows of it."""
        file = program if file is None else (program.parent / file)
        if file not in where:
            where[file] = file.read_text(errors="replace").splitlines() if file.exists() else []
        return words(where[file][line - 1]) if line and line <= len(where[file]) else ""

    our_path = steps.run(ours, program, tools, None, 60, marks)
    # Errors are told by the text of their line; lines of moves are not shown by a program without N words.
    their_path.error_line = words(answer.text) if answer.error else None
    if our_path.error and any(words in our_path.error for words in differential.NOT_CARRIED):
        return "stop at a word not carried", our_path.error
    if (their_path.error or "").startswith("File ended"):
        # At the last line, whatever it holds: that of ours may be any behind the last word.
        their_path.error_line = last_words(program)
        if our_path.error and "FC-0606" in our_path.error and COMMENT.sub("", our_path.error_line or "").strip() == "":
            our_path.error_line = their_path.error_line
    sought = differential.SOUGHT.search(their_path.error or "")
    if sought:
        their_path.error_line = marks(None, int(sought.group(2)))
    difference = compare.compare(their_path, our_path)
    if difference is None:
        return ("same error" if answer.error else "same motion"), ""
    known = deviations.SAMPLES.get(program.name)
    if known:
        return f"known deviation: {known}", ""
    return "differs", f"{difference.kind}: {difference.text}"


if __name__ == "__main__":
    sys.exit(main())
