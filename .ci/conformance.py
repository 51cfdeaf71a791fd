#!/usr/bin/env python3
"""Runs the conformance cases of some dialects and holds them against a list of known failures.

    conformance.py FOLDER BINARY KNOWN DIALECT ...

FOLDER holds run.py and the cases. KNOWN names one case a line (`gsk990mc/comp-example`), with the
reason behind `#`. A case that fails and is not named there fails the run; so does a named one that
passes, because its line is to go, and one that does not exist.
"""
import pathlib
import subprocess
import sys


def known_failures(path, dialects):
    if not path.exists():
        return set()
    lines = (line.split("#", 1)[0].strip() for line in path.read_text(encoding="utf-8").splitlines())
    return {line for line in lines if line and line.split("/", 1)[0] in dialects}


def results(folder, binary, dialect):
    """The text that run.py prints of every case, by its name: whether it passed, and why not."""
    command = [sys.executable, str(folder / "run.py"), "--bin", str(binary), "--only", dialect + "/*", "-v"]
    run = subprocess.run(command, capture_output=True, text=True)
    found, name = {}, None
    for line in run.stdout.splitlines():
        verdict, _, rest = line.partition(" ")
        if verdict in ("ok", "FAIL"):
            name = rest.strip()
            found[name] = (verdict == "ok", [])
        elif name and line.startswith("    "):
            found[name][1].append(line)
    if not found:
        sys.exit(f"no cases of {dialect} were run: {run.stderr.strip() or run.stdout.strip()}")
    return found


def main():
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    folder, binary, known_path = (pathlib.Path(a) for a in sys.argv[1:4])
    dialects = sys.argv[4:]
    known = known_failures(known_path, dialects)
    found = {}
    for dialect in dialects:
        found.update(results(folder, binary.resolve(), dialect))
    passed = {name for name, (ok, _) in found.items() if ok}
    failed = set(found) - passed
    for name in sorted(failed - known):
        print("FAIL " + name)
        print("\n".join(found[name][1]))
    for name in sorted(failed & known):
        print(f"known {name}")
    for name in sorted(passed & known):
        print(f"FAIL {name} passes: remove its line from {known_path}")
    for name in sorted(known - set(found)):
        print(f"FAIL {name} in {known_path} is no case")
    print(f"conformance: {len(passed)} passed, {len(failed)} failed ({len(failed & known)} of them known)")
    return 1 if failed - known or known - failed else 0


if __name__ == "__main__":
    sys.exit(main())
