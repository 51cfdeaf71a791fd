"""bCNC on a virtual display at the machine's Grbl port.

    bcnc.py 127.0.0.1:2323

It is driven over the web page that it has for a pendant: connects, homes, jogs, streams a program of 5,000 lines with a
hold and an override in it, and finishes. Judged by what bCNC shows its user: state and position.
"""

import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import urllib.parse
import urllib.request

from sender import job

CONFIG = """[bCNC]
lang =
[Connection]
controller = GRBL1
port = {port}
baud = 115200
openserial = 1
pendant = 1
pendantport = {pendant}
[CNC]
check = 0
"""


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Bcnc:
    def __init__(self, where, home):
        self.pendant = free_port()
        port = f"socket://{where}"
        pathlib.Path(home, ".bCNC").write_text(CONFIG.format(port=port, pendant=self.pendant))
        display = next(n for n in range(99, 200) if not pathlib.Path(f"/tmp/.X11-unix/X{n}").exists())
        self.log = open(pathlib.Path(home, "log"), "w+")
        show = dict(stdout=self.log, stderr=self.log)
        self.screen = subprocess.Popen(
            ["Xvfb", f":{display}", "-screen", "0", "1280x900x24", "-nolisten", "tcp"], **show
        )
        # Debian's program with Debian's Python: another one that comes first has not its libraries.
        path = f"/usr/bin:/bin:{os.environ.get('PATH', '')}"
        environment = dict(os.environ, HOME=home, DISPLAY=f":{display}", LANG="C.UTF-8", PATH=path)
        time.sleep(1)
        self.program = subprocess.Popen(["bCNC", "-s", port], env=environment, cwd=home, **show)

    def end(self):
        for process in (self.program, self.screen):
            process.send_signal(signal.SIGKILL)
            process.wait()

    def get(self, path):
        with urllib.request.urlopen(f"http://127.0.0.1:{self.pendant}{path}", timeout=10) as answer:
            return answer.read()

    def state(self):
        try:
            return json.loads(self.get("/state"))
        except OSError:
            return {"state": "not there yet"}

    def do(self, **what):
        self.get("/send?" + urllib.parse.urlencode(what))

    def until(self, wanted, seconds, what):
        deadline = time.monotonic() + seconds
        while not wanted(state := self.state()):
            if time.monotonic() > deadline or self.program.poll() is not None:
                self.log.seek(0)
                raise SystemExit(f"{what}: not within {seconds} s; {state}\n{self.log.read()[-2000:]}")
            time.sleep(0.05)
        return state


def main():
    where = sys.argv[1]
    home = tempfile.mkdtemp()
    bcnc = Bcnc(where, home)
    try:
        drive(bcnc, home)
    finally:
        bcnc.end()
        shutil.rmtree(home, ignore_errors=True)


def drive(bcnc, home):
    # A machine that was just switched on is locked.
    bcnc.until(lambda s: s["state"] in ("Alarm", "Idle"), 60, "connection")
    bcnc.do(cmd="HOME")
    bcnc.until(lambda s: s["state"] == "Idle", 60, "homing")
    bcnc.do(gcode="$J=G91 G21 X10 Y-5 F2000")
    bcnc.until(lambda s: abs(s["mx"] - 10) < 0.001 and abs(s["my"] + 5) < 0.001, 20, "jog")
    bcnc.until(lambda s: s["state"] == "Idle", 10, "end of the jog")
    lines = job()
    program = pathlib.Path(home, "job.ngc")
    program.write_text("\n".join(lines) + "\n")
    bcnc.do(cmd=f"LOAD {program}")
    time.sleep(2)
    began = time.monotonic()
    bcnc.do(cmd="RUN")
    bcnc.until(lambda s: s["state"] == "Run" and abs(s["mx"]) > 5, 60, "start of the program")
    bcnc.do(cmd="FEEDHOLD")
    held = bcnc.until(lambda s: s["state"].startswith("Hold"), 10, "hold")
    time.sleep(0.5)
    held = bcnc.until(lambda s: s["state"] == "Hold:0", 10, "standstill")
    time.sleep(0.5)
    later = bcnc.state()
    assert (held["mx"], held["my"]) == (later["mx"], later["my"]), (held, later)
    bcnc.do(cmd="SENDHEX 91")
    bcnc.do(cmd="SENDHEX 91")
    bcnc.do(cmd="RESUME")
    bcnc.until(lambda s: s["OvFeed"] == 120, 20, "override")
    end = bcnc.until(
        lambda s: s["state"] == "Idle" and abs(s["mx"]) < 0.001 and abs(s["mz"] - 2) < 0.001, 150, "end of the program"
    )
    took = time.monotonic() - began
    assert abs(end["my"]) < 0.001, end
    print(f"bCNC: homed, jogged, {len(lines)} lines in {took:.1f} s with hold and override, finished")


if __name__ == "__main__":
    main()
