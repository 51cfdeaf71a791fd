#!/usr/bin/env python3
"""Runs published paths and judges the setpoints; called by .ci/oracles.

    oracles.py ORACLES SAMPLES

Each path is run twice: with all its limits, and without those of jerk. Fails where the judge finds a limit, the path, the
feed or the end not kept, or where a path takes too long: more than MOST times the least time that is known with limits of
jerk, or more than MOST_WITHOUT_JERK times the least with those of velocity and acceleration alone.
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

MOST = 1.10

# What is smooth but for its many blocks.
CLOSE = {"circle500": 1.03, "raster20k": 1.03}

MOST_WITHOUT_JERK = 1.02


def main():
    oracles, samples = pathlib.Path(sys.argv[1]), sys.argv[2]
    paths = sorted(path for path in (oracles / "paths").glob("*.json") if path.name != "bounds.json")
    if not paths:
        sys.exit(f"no paths in {oracles}")
    bounds = json.loads((oracles / "paths" / "bounds.json").read_text())
    faults = 0
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for path in paths:
            most = CLOSE.get(path.stem, MOST)
            faults += not judged(oracles, samples, folder, path, bounds[path.name], "t_jerk", most)
        for path in paths:
            whole = json.loads(path.read_text())
            del whole["jmax"]
            without = folder / path.name
            without.write_text(json.dumps(whole))
            # Corners may be rounded where there is a tolerance.
            bound = "t_tol" if whole["tolerance"] > 0.0 else "t_exact"
            faults += not judged(oracles, samples, folder, without, bounds[path.name], bound, MOST_WITHOUT_JERK)
    sys.exit(1 if faults else 0)


def judged(oracles, samples, folder, path, bounds, bound, most):
    """Runs a path; whether everything held, and it took `most` times the time of `bound` at most."""
    csv = str(folder / "samples.csv")
    subprocess.run([samples, str(path), csv], check=True, stdout=subprocess.DEVNULL)
    judge = [sys.executable, str(oracles / "judge_samples.py"), csv, str(path), "--json"]
    # Nothing is written beside the judge.
    environment = {**os.environ, "NUMBA_CACHE_DIR": str(folder), "PYTHONDONTWRITEBYTECODE": "1"}
    run = subprocess.run(judge, capture_output=True, text=True, env=environment)
    if not run.stdout.lstrip().startswith("{"):
        sys.exit(f"{path.stem}: the judge failed: {run.stderr.strip()}")
    found = json.loads(run.stdout)
    ratio = found["time_s"] / bounds[bound]
    is_good = found["verdict"] == "PASS" and ratio <= most
    print(f"{'ok' if is_good else 'FAULT'} {path.stem}: {found['time_s']:.3f} s, {ratio:.4f} of {bound}, at most {most}")
    for fail in found["fails"]:
        print(f"    {fail}")
    return is_good


main()
