"""Is a hostile robot to `coppice live` and to the editor, and looks at what memory that takes.

usage: robot_attack.py COPPICE MEBIBYTES EDITOR
EDITOR: ON or OFF, whether there is one.
"""
import os
import re
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest

PATIENCE = 20  # s, for what must happen
ATTACK = 2  # s, in which the robot says what it can
RUN = bytes(16)


def frame(flags, body):
    if len(body) > 255:
        return struct.pack(">BQ", flags | 2, len(body)) + body
    return struct.pack(">BB", flags, len(body)) + body


GREETING = b"\xff" + bytes(8) + b"\x7f\x03\x00" + b"NULL".ljust(20, b"\0") + bytes(32)
READY = frame(4, b"\x05READY\x0bSocket-Type" + struct.pack(">I", 6) + b"ROUTER")
ANNOUNCED = 64 << 20  # bytes: as large as a message may be


class Robot:
    """Greets everybody as a robot does, and then says `pieces` again and again."""

    def __init__(self, begin, pieces):
        self.begin, self.pieces = begin, pieces
        self.door = socket.create_server(("127.0.0.1", 0))
        self.port = self.door.getsockname()[1]
        self.sent = 0
        threading.Thread(target=self.serve, daemon=True).start()

    def serve(self):
        while True:
            try:
                connection, _ = self.door.accept()
            except OSError:
                return
            threading.Thread(target=self.talk, args=(connection,), daemon=True).start()

    def talk(self, connection):
        try:
            connection.sendall(GREETING + READY + self.begin)
            connection.settimeout(PATIENCE)
            while True:
                connection.sendall(self.pieces)
                self.sent += len(self.pieces)
        except OSError:
            connection.close()


def memory_of(process):
    with open("/proc/%d/status" % process.pid) as file:
        return int(re.search(r"VmHWM:\s+(\d+)", file.read()).group(1)) << 10


class Client(unittest.TestCase):
    def attack(self, begin, pieces, until=None):
        """What the client prints: until that is among it, or else in the time of an attack."""
        robot = Robot(begin, pieces)
        environment = dict(os.environ)
        environment.pop("COPPICE_LIVE_TOKEN", None)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "printed")
            printed = lambda: open(path, errors="replace").read()
            with open(path, "w") as file:
                process = subprocess.Popen([PROGRAM, "live", "127.0.0.1:%d" % robot.port],
                                           env=environment, stdout=file, stderr=file)
            try:
                end = time.monotonic() + (PATIENCE if until else ATTACK)
                while time.monotonic() < end and not (until and until in printed()):
                    time.sleep(0.05)
                self.assertIsNone(process.poll(), "it waits for a better robot")
                self.assertLess(memory_of(process), MEMORY)
            finally:
                robot.door.close()
                process.terminate()
                process.wait(timeout=PATIENCE)
            printed = printed()
        self.assertLess(len(printed), 1 << 20)
        self.sent = robot.sent
        return printed

    def test_a_message_of_ever_more_parts_is_cut_off(self):
        self.assertIn("too large", self.attack(b"", frame(1, b"x" * 60_000), "too large"))

    def test_empty_parts_without_end_are_cut_off(self):
        self.assertIn("too large", self.attack(b"", frame(1, b"") * 10_000, "too large"))

    def test_a_part_of_exabytes_is_cut_off_when_it_is_announced(self):
        announced = struct.pack(">BQ", 2, 1 << 60)
        self.assertIn("too large", self.attack(b"", announced + bytes(65536), "too large"))

    def test_the_largest_part_that_is_possible_takes_what_has_come(self):
        begin = frame(1, b"") + struct.pack(">BQ", 2, ANNOUNCED)
        self.attack(begin, bytes(65536))
        self.assertGreater(self.sent, 0)

    def test_answers_of_the_largest_kind_are_no_more_than_one(self):
        header = struct.pack("<BcI", 2, b"C", 1) + RUN
        reply = b'{"error":"' + b"x" * (ANNOUNCED - 100) + b'"}'
        printed = self.attack(b"", frame(1, b"") + frame(1, header) + frame(0, reply),
                              "too large")
        self.assertIn("too large", printed)

    def test_a_refusal_as_long_as_a_message_is_no_more_than_one(self):
        self.attack(b"", frame(1, b"") + frame(1, b"error") + frame(0, b"x" * (ANNOUNCED - 100)))

    def test_pings_whose_answers_nobody_reads_are_not_kept(self):
        ping = frame(4, b"\x04PING\x00\x01" + b"c" * 16)
        self.attack(b"", ping * 3000)


class Editor(unittest.TestCase):
    def test_many_robots_that_send_the_largest_messages_take_no_more_than_one(self):
        if not HAS_EDITOR:
            self.skipTest("without the editor")
        begin = frame(1, b"") + struct.pack(">BQ", 2, ANNOUNCED)
        robots = [Robot(begin, bytes(65536)) for _ in range(4)]
        command = [PROGRAM, "edit", "--headless"]
        for robot in robots:
            self.addCleanup(robot.door.close)
            command += ["--connect", "127.0.0.1:%d" % robot.port]
        with tempfile.TemporaryDirectory() as folder:
            command += ["--picture", os.path.join(folder, "picture.png"), "--for", "30"]
            process = subprocess.Popen(command, env=dict(os.environ, HOME=folder),
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            try:
                end = time.monotonic() + PATIENCE
                while sum(robot.sent for robot in robots) < 4 * ANNOUNCED:
                    self.assertLess(time.monotonic(), end, "they are heard")
                    self.assertIsNone(process.poll())
                    time.sleep(0.05)
                self.assertLess(memory_of(process), MEMORY)
            finally:
                process.kill()
                process.wait(timeout=PATIENCE)


if __name__ == "__main__":
    HAS_EDITOR = sys.argv.pop(3) == "ON"
    MEMORY = int(sys.argv.pop(2)) << 20
    PROGRAM = sys.argv.pop(1)
    unittest.main(warnings="ignore")
