"""Runs LinuxCNC's stand-alone interpreter `rs274`, which is what Ferrocut's rs274 dialect is compared with.

The installed program prints four decimals and believes to count in inches whatever its ini file says:
2.5 µm where 0.5 µm are to be judged. So a copy of it is run, in which two constants are others: the
formats `%.4f` are `%.9f`, and the number of its length units in a millimetre is 1 instead of
0.03937007874016. Tool tables and parameter files are then in mm, as they are for a metric machine. All
that interprets is in the library beside it, which is not touched.
"""

import os
import pathlib
import re
import shutil
import struct
import subprocess

PROGRAM = "/usr/bin/rs274"
INCHES_IN_A_MM = struct.pack("<d", 0.03937007874016)
FOUR_DECIMALS = b"%.4f"


class NotUsable(Exception):
    """There is no rs274 here, or it is one that is built in another way."""


class Answer:
    """What the interpreter said to a program."""

    def __init__(self, calls, error, text, seconds):
        self.calls = calls        # canonical calls, a line each
        self.error = error        # its message, None where the program ran to its end
        self.text = text          # the text of the line at fault
        self.seconds = seconds    # CPU time


def installed():
    """The package's name and version."""
    if not os.path.exists(PROGRAM):
        raise NotUsable("rs274 of the package linuxcnc-uspace is not installed")
    asked = subprocess.run(
        ["dpkg-query", "-W", "-f", "${Package} ${Version}", "linuxcnc-uspace"], capture_output=True, text=True
    )
    return asked.stdout or "rs274 of unknown version"


def precise_copy(folder):
    """Writes the copy of the program that prints nine decimals and counts in mm; its path."""
    installed()
    image = pathlib.Path(PROGRAM).read_bytes()
    if image.count(INCHES_IN_A_MM) != 1 or image.count(FOUR_DECIMALS) < 20:
        raise NotUsable("this rs274 is built in another way: its formats or its unit of length are not found")
    image = image.replace(FOUR_DECIMALS, b"%.9f").replace(INCHES_IN_A_MM, struct.pack("<d", 1.0))
    copy = pathlib.Path(folder) / "rs274-precise"
    # Another process of this test may be running the file: it is put in place as a whole.
    made = copy.with_suffix(f".{os.getpid()}")
    made.write_bytes(image)
    made.chmod(0o755)
    os.replace(made, copy)
    return copy


def run(binary, program, home, tools=None, parameters=None, seconds=60):
    """Interprets `program` until its first error. `home` is this process's own folder: the program keeps
    its tool table there, and rewrites the file of parameters, of which it gets a copy."""
    home = pathlib.Path(home)
    own = home / "parameters.var"
    if parameters:
        shutil.copyfile(parameters, own)
    else:
        own.write_text("")
    command = [str(binary), "-g", "-v", str(own)]
    if tools:
        command += ["-t", str(tools)]
    before = os.times()
    try:
        done = subprocess.run(
            [*command, str(program)],
            cwd=pathlib.Path(program).parent,
            env={**os.environ, "HOME": str(home), "LC_ALL": "C"},
            capture_output=True,
            timeout=seconds,
        )
    except subprocess.TimeoutExpired as late:
        return Answer([], f"no end within {late.timeout} s", "", late.timeout)
    after = os.times()
    used = after.children_user - before.children_user + after.children_system - before.children_system
    calls = done.stdout.decode("utf-8", "replace").splitlines()
    said = done.stderr.decode("utf-8", "replace").splitlines()
    said = [line for line in said if line != "executing"]
    if done.returncode == 0:
        return Answer(calls, None, None, used)
    if done.returncode < 0:
        return Answer(calls, f"ended by signal {-done.returncode}", "", used)
    return Answer(calls, said[-2] if len(said) > 1 else " ".join(said), said[-1] if said else "", used)


def line_of(text):
    """The number with which the generator marks a line: its N word, or a comment `(L12)` at its end."""
    word = re.match(r"\s*/?\s*[nN]\s*(\d+)", text or "") or re.search(r"\(L(\d+)\)", text or "")
    return int(word.group(1)) if word else None
