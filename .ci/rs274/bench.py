#!/usr/bin/env python3
"""CPU time of Ferrocut and of LinuxCNC's `rs274` for the same long programs, one after the other.

    bench.py BINARY [--fail-below RATIO]

Both read the program and write everything that the machine is told to do, to nowhere. The installed
program runs as it is.
"""

import argparse
import os
import pathlib
import subprocess
import sys
import tempfile

import oracle
import steps


def blocks(out):
    """A million G1 blocks of two coordinates."""
    out.write("G21 G90 G17 G94\nG0 X0 Y0 Z5\nG1 Z-1 F1200\n")
    for i in range(1_000_000):
        out.write(f"G1 X{i % 997 / 10:.3f} Y{i * 7 % 1009 / 10:.3f}\n")
    out.write("M2\n")


def loop(out):
    """A million passes of a loop with two assignments."""
    out.write(
        "G21 G90 G17 G94\nG0 X0 Y0 Z5\n#1=0\n#2=0\n"
        "o100 while [#1 lt 1000000]\n#2=[#2+abs[sin[#1]]]\n#1=[#1+1]\no100 endwhile\nG0 X[#2/100000]\nM2\n"
    )


def calls(out):
    """900,000 calls of a subprogram that adds its argument up."""
    out.write(
        "G21 G90 G17 G94\nG0 X0 Y0 Z5\no100 sub\n#<_sum>=[#<_sum>+#1]\no100 endsub\n#<_sum>=0\n"
        "o101 repeat [900000]\no100 call [0.5]\no101 endrepeat\nG0 X[#<_sum>/10000]\nM2\n"
    )


def cpu_seconds(command, **more):
    """CPU time of a program that must succeed, user and system."""
    before = os.times()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, **more)
    after = os.times()
    return after.children_user - before.children_user + after.children_system - before.children_system


def main():
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("binary")
    asked.add_argument("--fail-below", type=float, default=0.0, help="smallest ratio that is no failure")
    arguments = asked.parse_args()
    try:
        name = oracle.installed()
    except oracle.NotUsable as why:
        print(f"left out: {why}")
        return 0
    ours = str(pathlib.Path(arguments.binary).resolve())
    least = float("inf")
    with tempfile.TemporaryDirectory(prefix="rs274-") as folder:
        print(f"CPU time, {name} and Ferrocut")
        for write in (blocks, loop, calls):
            program = pathlib.Path(folder) / f"{write.__name__}.ngc"
            with open(program, "w") as out:
                write(out)
            home = {**os.environ, "HOME": folder}
            parameters = pathlib.Path(folder) / "parameters.var"
            parameters.write_text("")
            theirs = cpu_seconds([oracle.PROGRAM, "-g", "-v", str(parameters), str(program)], env=home, cwd=folder)
            trace = [ours, "trace", "--dialect", "rs274", "--machine", str(steps.HERE / "mill.toml"), str(program)]
            own = min(cpu_seconds(trace) for _ in range(2))
            least = min(least, theirs / own)
            print(f"  {write.__doc__:52} {theirs:7.2f} s {own:7.2f} s   {theirs / own:5.1f} times faster")
    return 1 if least < arguments.fail_below else 0


if __name__ == "__main__":
    sys.exit(main())
