"""Runs `ferrocut trace` and reads its steps."""

import json
import math
import os
import pathlib
import subprocess

from path import AXES, PLANES, Move, Path

HERE = pathlib.Path(__file__).parent


def run(binary, program, tools=None, parameters=None, seconds=60, marks=None):
    """The path of a program, which is interpreted until its first alarm. `marks` gives the marked line of
    a file and line, since alarms and steps name the file's own lines."""
    command = [str(binary), "trace", "--dialect", "rs274", "--machine", str(HERE / "mill.toml"), "--language", "en"]
    command += ["--tool-table", str(tools)] if tools else []
    command += ["--var-file", str(parameters)] if parameters else []
    try:
        done = subprocess.run(
            [*command, str(program)], capture_output=True, timeout=seconds, cwd=pathlib.Path(program).parent
        )
    except subprocess.TimeoutExpired as late:
        return Path([], f"no end within {late.timeout} s")
    path = read(done.stdout.decode("utf-8", "replace").splitlines(), marks or (lambda file, line: line))
    if done.returncode not in (0, 1):
        said = done.stderr.decode("utf-8", "replace").strip().splitlines()
        path.error = f"exit {done.returncode}: {' '.join(said[-3:])}"
    elif done.returncode == 1 and path.error is None:
        path.error = "exit 1 without an alarm: " + done.stderr.decode("utf-8", "replace")[-300:]
    return path


def read(lines, marks):
    path = Path([])
    at = [0.0] * 6
    for text in lines:
        step = json.loads(text)
        op = step["op"]
        line = marks(step.get("file"), step.get("line"))
        if op == "alarm":
            path.error = f"{step.get('no')} {step.get('text', '')}"
            path.error_line = line
        elif op == "message":
            path.messages.append(step["text"])
        elif op == "dwell" and step.get("s", step.get("rev")) > 0:
            path.events.append(("dwell", step.get("s", step.get("rev"))))
        elif op == "change":
            path.events.append(("change", float(step["t"])))
        elif op == "stop" and step["code"] != "M01":
            path.events.append(("stop", "M00"))
        elif op in KINDS:
            end = list(at)
            for name, value in step.get("to", {}).items():
                if name in AXES:
                    end[AXES.index(name)] = value
            move = Move(KINDS[op], tuple(at), tuple(end), line)
            if op == "arc":
                move.plane = step["plane"]
                move.center = tuple(step["center"])
                move.sweep = math.radians(step["sweep"])
            if op == "tap":
                move.pitch = step["pitch"]
            for key, mode in (("f", "f"), ("frev", "frev"), ("duration", "s")):
                if key in step:
                    move.feed = (mode, step[key])
            path.moves.append(move)
            at = end
    return path


KINDS = {"rapid": "rapid", "feed": "feed", "arc": "arc", "tap": "sync", "skip": "probe"}
