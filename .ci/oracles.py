#!/usr/bin/env python3
"""Runs published paths and judges the setpoints; called by .ci/oracles.

    oracles.py ORACLES SAMPLES

Fails where the judge finds a limit, the path, the feed or the end not kept, or where a path takes more than MOST times
the least time that is known with limits of jerk.
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


def main():
    oracles, samples = pathlib.Path(sys.argv[1]), sys.argv[2]
    paths = sorted(path for path in (oracles / "paths").glob("*.json") if path.name != "bounds.json")
    if not paths:
        sys.exit(f"no paths in {oracles}")
    faults = 0
    with tempfile.TemporaryDirectory() as folder:
        # Nothing is written beside the judge.
        environment = {**os.environ, "NUMBA_CACHE_DIR": folder, "PYTHONDONTWRITEBYTECODE": "1"}
        for path in paths:
            csv = str(pathlib.Path(folder) / "samples.csv")
            subprocess.run([samples, str(path), csv], check=True, stdout=subprocess.DEVNULL)
            judge = [sys.executable, str(oracles / "judge_samples.py"), csv, str(path), "--json"]
            run = subprocess.run(judge, capture_output=True, text=True, env=environment)
            if not run.stdout.lstrip().startswith("{"):
                sys.exit(f"{path.stem}: the judge failed: {run.stderr.strip()}")
            found = json.loads(run.stdout)
            bound, ratio = CLOSE.get(path.stem, MOST), found.get("ratio_jerk")
            is_good = found["verdict"] == "PASS" and ratio is not None and ratio <= bound
            faults += not is_good
            print(f"{'ok' if is_good else 'FAULT'} {path.stem}: {found['time_s']:.3f} s, {ratio} of t_jerk, at most {bound}")
            for fail in found["fails"]:
                print(f"    {fail}")
    sys.exit(1 if faults else 0)


main()
