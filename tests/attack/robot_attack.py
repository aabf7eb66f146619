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


class Door:
    """Has a thread for each who connects, which calls talk()."""

    def __init__(self):
        self.door = socket.create_server(("127.0.0.1", 0))
        self.port = self.door.getsockname()[1]
        threading.Thread(target=self.serve, daemon=True).start()

    def serve(self):
        while True:
            try:
                connection, _ = self.door.accept()
            except OSError:
                return
            threading.Thread(target=self.talk, args=(connection,), daemon=True).start()


class Robot(Door):
    """Greets everybody as a robot does, and then says `pieces` again and again."""

    def __init__(self, begin, pieces):
        self.begin, self.pieces = begin, pieces
        self.sent = 0
        super().__init__()

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


def answer(header, *body):
    parts = [b"", header + RUN, *body]
    return b"".join(frame(part is not parts[-1], part) for part in parts)


def boards(keys):
    """The blackboard "Main" as MessagePack: `keys` with one byte each."""
    pack = bytearray(b"\x81\xa4Main\xdf" + struct.pack(">I", len(keys)))
    for key in keys:
        pack += bytes([0xa0 | len(key)]) + key + b"\xc3"
    return bytes(pack)


class Groot2Robot(Door):
    """Knows the protocol of Groot2 alone, and answers what is asked with `answers` (by its letter,
    each a text or what makes one of the number of the question)."""

    TREE = b"""<root BTCPP_format="4"><BehaviorTree ID="Main" _fullpath="">
        <AlwaysSuccess name="a" _uid="1"/></BehaviorTree></root>"""

    def __init__(self, answers):
        self.answers = {b"T": self.TREE, b"S": b"\1\0\2", b"B": b"\x80", b"D": b"[]",
                        b"r": b"1000000", b"t": b"", **answers}
        self.asked = {}
        super().__init__()

    def talk(self, connection):
        try:
            connection.sendall(GREETING + READY)
            stream = connection.makefile("rb")
            stream.read(len(GREETING))
            while True:
                flags = stream.read(1)[0]
                size = struct.unpack(">Q", stream.read(8))[0] if flags & 2 else stream.read(1)[0]
                body = stream.read(size)
                if not flags & 4 and len(body) == 6 and body[:1] == b"\2":
                    connection.sendall(self.reply(body))
        except (OSError, IndexError, struct.error):
            connection.close()

    def reply(self, header):
        what = header[1:2]
        number = self.asked[what] = self.asked.get(what, 0) + 1
        if what not in self.answers:
            return frame(1, b"") + frame(1, b"error") + frame(0, b"Request not recognized")
        body = self.answers[what]
        return answer(header, body(number) if callable(body) else body)


class Groot2(unittest.TestCase):
    def watch(self, answers, letter, times):
        """With `coppice live`, until that has been asked so often."""
        robot = Groot2Robot(answers)
        self.addCleanup(robot.door.close)
        environment = dict(os.environ)
        environment.pop("COPPICE_LIVE_TOKEN", None)
        process = subprocess.Popen([PROGRAM, "live", "127.0.0.1:%d" % robot.port],
                                   env=environment, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        try:
            end = time.monotonic() + PATIENCE
            while robot.asked.get(letter, 0) < times:
                self.assertLess(time.monotonic(), end, "it asks: %s" % robot.asked)
                self.assertIsNone(process.poll())
                time.sleep(0.05)
            self.assertLess(memory_of(process), MEMORY)
        finally:
            process.kill()
            process.wait(timeout=PATIENCE)

    def test_other_keys_again_and_again_are_not_kept_without_end(self):
        make = lambda number: boards([b"%04x%05x" % (number, i) for i in range(90_000)])
        self.watch({b"B": make}, b"B", 9)

    def test_more_values_than_there_is_memory_for_are_no_blackboard(self):
        nils = b"\x81\xa4Main\x81\xa1k\xdd" + struct.pack(">I", 15_000_000) + b"\xc0" * 15_000_000
        self.watch({b"B": nils}, b"B", 2)

    def test_breakpoints_that_are_none_by_the_million_are_none(self):
        self.watch({b"D": b"[" + b"[]," * 5_000_000 + b"0]"}, b"D", 2)


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
