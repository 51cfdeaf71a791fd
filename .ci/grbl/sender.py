"""A Grbl sender that counts characters, as UGS and CNCjs do, and judges the machine by what it answers.

    sender.py tcp 127.0.0.1:2323
    sender.py pty /dev/pts/5

Unlocks by homing, jogs, streams 5,000 lines with a hold and overrides in them, resets, and reads positions. Ends with
status 0 where all was as Grbl 1.1 says, and says what was not.
"""

import collections
import math
import os
import re
import select
import socket
import sys
import termios
import time
import tty

RECEIVE = 128
LINES = 5000


class Sender:
    def __init__(self, kind, where):
        if kind == "tcp":
            host, port = where.rsplit(":", 1)
            self.socket = socket.create_connection((host, int(port)), timeout=10)
            self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self.file = self.socket.fileno()
        else:
            self.file = os.open(where, os.O_RDWR | os.O_NOCTTY)
            tty.setraw(self.file)
            attributes = termios.tcgetattr(self.file)
            attributes[4] = attributes[5] = termios.B115200
            termios.tcsetattr(self.file, termios.TCSANOW, attributes)
        os.set_blocking(self.file, False)
        self.rest = b""
        self.heard = collections.deque()
        self.state = self.position = self.fields = None
        self.reports = 0

    def write(self, data):
        while data:
            select.select([], [self.file], [], 10)
            data = data[os.write(self.file, data):]

    def read(self, timeout):
        """Lines that came; status reports are taken out."""
        readable, _, _ = select.select([self.file], [], [], timeout)
        if not readable:
            return
        data = os.read(self.file, 65536)
        if not data:
            raise SystemExit("the machine closed the connection")
        *lines, self.rest = (self.rest + data).split(b"\r\n")
        for line in map(bytes.decode, lines):
            if line.startswith("<"):
                fields = line.strip("<>").split("|")
                self.state = fields[0]
                self.fields = dict(field.split(":", 1) for field in fields[1:])
                numbers = self.fields["MPos"].split(",")
                assert all("." in number for number in numbers), line
                self.position = [float(number) for number in numbers]
                self.reports += 1
            elif line:
                self.heard.append(line)

    def until(self, wanted, seconds, what):
        deadline = time.monotonic() + seconds
        asked = 0.0
        while not wanted():
            if time.monotonic() > deadline:
                raise SystemExit(f"{what}: not within {seconds} s; {self.state} {self.position} {list(self.heard)[-5:]}")
            if time.monotonic() - asked > 0.1:
                asked = time.monotonic()
                self.write(b"?")
            self.read(0.02)

    def ask(self, line, seconds=10):
        """Sends a line and returns what came up to its answer."""
        self.heard.clear()
        self.write(line.encode() + b"\n")
        answered = lambda: any(h == "ok" or h.startswith("error") for h in self.heard)
        self.until(answered, seconds, line)
        return list(self.heard)

    def idle(self, seconds):
        count = self.reports
        self.until(lambda: self.state == "Idle" and self.reports > count + 1, seconds, "idle")

    def stream(self, lines, at):
        """Sends lines as long as they fit the receive buffer; `at` has what is done at which answered line."""
        sent = collections.deque()
        answered = following = 0
        self.heard.clear()
        last, asked = time.monotonic(), 0.0
        while answered < len(lines):
            while following < len(lines) and sum(sent) + len(lines[following]) + 1 < RECEIVE:
                sent.append(len(lines[following]) + 1)
                self.write(lines[following].encode() + b"\n")
                following += 1
            # As CNCjs does.
            if time.monotonic() - asked > 0.25:
                asked = time.monotonic()
                self.write(b"?")
            self.read(0.05)
            while self.heard:
                line = self.heard.popleft()
                if line == "ok":
                    sent.popleft()
                    answered += 1
                    last = time.monotonic()
                    if answered in at:
                        at[answered](self)
                elif line.startswith(("error", "ALARM")):
                    raise SystemExit(f"line {answered + 1} ({lines[answered]}): {line}")
            if time.monotonic() - last > 30:
                raise SystemExit(f"no answer to line {answered + 1}; {self.state}")


def job():
    """A spiral of short lines, as programs of surfaces have them."""
    lines = ["G21", "G90 G94 G17", "G54", "M3 S4000", "G0 X0 Y0 Z2", "G1 Z-0.5 F1500"]
    count = LINES - len(lines) - 5
    for k in range(count):
        angle = k * 0.01
        radius = 2 + k * 0.004
        lines.append(f"G1X{radius * math.cos(angle):.3f}Y{radius * math.sin(angle):.3f}F6000")
    lines += ["G0 Z2", "G0 X0 Y0", "M5", "G4 P0.1", "M2"]
    assert len(lines) == LINES
    return lines


def hold(sender):
    """Holds, sees the machine stand, and goes on with another feed."""
    sender.write(b"!")
    sender.until(lambda: sender.state == "Hold:0", 10, "hold")
    at = sender.position
    time.sleep(0.3)
    count = sender.reports
    sender.until(lambda: sender.reports > count + 1, 5, "report")
    assert sender.position == at, (sender.position, at)
    sender.write("\x91\x91".encode() + b"~")
    sender.until(lambda: sender.state != "Hold:0", 10, "cycle start")
    seen = []
    sender.until(lambda: seen.append(sender.fields.get("Ov")) or "120,100,100" in seen, 20, "override")


def close_to(at, wanted):
    return all(abs(a - b) < 0.0015 for a, b in zip(at, wanted))


def main():
    kind, where = sys.argv[1:3]
    sender = Sender(kind, where)
    if kind == "pty":
        # A serial port greets nobody who comes later.
        time.sleep(0.2)
        sender.write(b"\x18")
    sender.until(lambda: any(h.startswith("Grbl 1.1") for h in sender.heard), 10, "greeting")
    version = sender.ask("$I")
    assert any(re.match(r"\[OPT:V.*,15,128\]", h) for h in version), version
    settings = sender.ask("$$")
    for number in (10, 11, 13, 20, 27, 30, 32, 100, 112, 120, 132):
        assert any(h.startswith(f"${number}=") for h in settings), (number, settings)
    assert sender.ask("$H", 60)[-1] == "ok"
    sender.idle(10)
    assert sender.ask("$J=G91 G21 X10 Y-5 F2000")[-1] == "ok"
    sender.idle(10)
    assert close_to(sender.position[:2], [10, -5]), sender.position
    # A long jog is cut short.
    sender.ask("$J=G91 X100 F2000")
    sender.until(lambda: sender.state == "Jog" and sender.position[0] > 12, 10, "jog")
    sender.write(b"\x85")
    sender.idle(10)
    assert 12 < sender.position[0] < 60, sender.position
    assert sender.ask("$J=G90 X99999 F100")[-1] == "error:15"
    assert sender.ask("G0 X0 Y0")[-1] == "ok"
    sender.idle(20)
    began = time.monotonic()
    sender.stream(job(), {2000: hold})
    took = time.monotonic() - began
    sender.idle(30)
    assert close_to(sender.position, [0, 0, 2]), sender.position
    codes = next(h for h in sender.ask("$G") if h.startswith("[GC:"))
    assert "G54 G17 G21 G90 G94 M5 M9" in codes, codes
    # A reset in motion is an alarm, and keeps the machine where it stands.
    sender.ask("G1 X100 F2000")
    sender.until(lambda: sender.position[0] > 3, 10, "motion")
    sender.heard.clear()
    sender.write(b"\x18")
    sender.until(lambda: any(h.startswith("Grbl") for h in sender.heard), 10, "greeting")
    assert "ALARM:3" in sender.heard, sender.heard
    sender.until(lambda: sender.state == "Alarm", 5, "alarm")
    assert sender.ask("G0 X0")[-1] == "error:9"
    assert sender.ask("$X")[-1] == "ok"
    sender.idle(10)
    assert 3 < sender.position[0] < 99
    print(f"{kind}: {LINES} lines in {took:.1f} s, {sender.reports} status reports, all as Grbl says")


if __name__ == "__main__":
    main()
