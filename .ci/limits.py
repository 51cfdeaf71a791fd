#!/usr/bin/env python3
"""Judges setpoints written by `ferrocut run --samples` against the limits of the machine file.

    limits.py MACHINE.toml SAMPLES.csv

Finite differences of first, second and third order, with the axes at rest before and after, must stay within 1.001
of the rapid or cutting speed (whichever is higher), of the acceleration and of the jerk of every axis. Jerk is seen
over three periods; the last digit of the samples adds to it.
"""
import sys
import tomllib

SLACK = 1.001

# Samples have nine digits behind the point; four of them make a third difference.
ROUNDING = 8 * 0.5e-9


def main():
    machine_path, samples_path = sys.argv[1:3]
    with open(machine_path, "rb") as file:
        machine = tomllib.load(file)
    period = machine.get("servo_period_ms", 1.0) / 1000
    with open(samples_path, encoding="ascii") as file:
        names = file.readline().strip().split(",")[1:]
        rows = [[float(v) for v in line.split(",")] for line in file]
    if len(rows) < 1000:
        sys.exit(f"{len(rows)} samples: the job did not run")
    for k, row in enumerate(rows):
        if abs(row[0] - k * period) > 1e-9:
            sys.exit(f"sample {k} at {row[0]} s: not one sample a servo period")
    limits = {axis["name"].lower(): axis for axis in machine["axes"]}
    faults = 0
    for column, name in enumerate(names, 1):
        axis = limits[name]
        q = [row[column] for row in rows]
        q = [q[0]] * 3 + q + [q[-1]] * 3
        velocity = max(abs(b - a) for a, b in zip(q, q[1:])) / period
        acceleration = max(abs(c - 2 * b + a) for a, b, c in zip(q, q[1:], q[2:])) / period**2
        third = max(abs(d - 3 * c + 3 * b - a) for a, b, c, d in zip(q, q[1:], q[2:], q[3:]))
        jerk = max(third - ROUNDING, 0) / period**3
        for what, value, limit, unit in (
            ("velocity", velocity, max(axis["rapid"], axis["velocity"]) / 60, "mm/s"),
            ("acceleration", acceleration, axis["acceleration"], "mm/s2"),
            ("jerk", jerk, axis.get("jerk", 0) or float("inf"), "mm/s3"),
        ):
            verdict = "ok  " if value <= limit * SLACK else "FAIL"
            faults += verdict == "FAIL"
            print(f"{verdict} {name.upper()} {what} {value:.3f} of {limit:.3f} {unit}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
