"""Gives the robot's programs the records and maps of an attacker, and one their answers to keep. As
file_attack.py: each must end with a message, soon, and without taking the memory of the computer.

usage: recording_attack.py COPPICE MIB
"""
import bz2
import os
import re
import signal
import struct
import subprocess
import sys
import unittest
import urllib.error
import urllib.request

import file_attack
from file_attack import FileAttack

CLOUDS, CLOUD = b"/velodyne_points", b"sensor_msgs/PointCloud2"
CLOUD_MD5 = b"1158d486dd51d683ce2f1be655c3c181"
TIME = struct.pack("<II", 100, 0)
EMPTY_CLOUD = struct.pack("<IIIIIIIBIII", 1, 0, 0, 0, 1, 1, 0, 0, 1, 1, 1) + b"\0\0"


def number(value):
    return struct.pack("<I", value)


def part(fields, data):
    """A part of a bag: its header and its data, each with its length."""
    header = b"".join(number(len(key) + 1 + len(value)) + key + b"=" + value
                      for key, value in fields.items())
    return number(len(header)) + header + number(len(data)) + data


def bag(message=EMPTY_CLOUD, chunk=None, size=None, compression=b"none", offset=None):
    """A record of one cloud. What the chunk is said to hold, and where in it the cloud is, may lie."""
    connection = part({b"op": b"\x07", b"conn": number(0), b"topic": CLOUDS}, b"".join(
        number(len(field)) + field for field in (b"topic=" + CLOUDS, b"type=" + CLOUD,
                                                 b"md5sum=" + CLOUD_MD5, b"message_definition=")))
    content = connection + part({b"op": b"\x02", b"conn": number(0), b"time": TIME}, message)
    chunk = part({b"op": b"\x05", b"compression": compression,
                  b"size": number(len(content) if size is None else size)},
                 content if chunk is None else chunk)
    index = part({b"op": b"\x04", b"ver": number(1), b"conn": number(0), b"count": number(1)},
                 TIME + number(len(connection) if offset is None else offset))
    begin = 13 + 4096
    head = part({b"op": b"\x03", b"index_pos": struct.pack("<Q", begin + len(chunk + index)),
                 b"conn_count": number(1), b"chunk_count": number(1)}, b"")[:-4]
    return (b"#ROSBAG V2.0\n" + head + number(4092 - len(head)) + b" " * (4092 - len(head)) + chunk
            + index + connection + part(
                {b"op": b"\x06", b"ver": number(1), b"chunk_pos": struct.pack("<Q", begin),
                 b"start_time": TIME, b"end_time": TIME, b"count": number(1)},
                number(0) + number(1)))


class Bags(FileAttack):
    def look(self, record, codes=(1,)):
        self.write("r.bag", record)
        return self.run_program("people", "--offline", "r.bag", codes=codes)

    def test_a_cloud_that_the_index_places_outside_of_the_record_is_no_crash(self):
        self.assertIn("0 people", self.look(bag(), codes=(0,)))
        for offset in (0x7FFFFFF0, 0xFFFFFFF0):
            self.assertIn("damaged", self.look(bag(offset=offset)))

    def test_a_record_that_unpacks_to_gigabytes_is_damaged(self):
        bomb = bz2.compress(bytes(1 << 28))
        self.assertIn("damaged", self.look(bag(chunk=bomb, size=1 << 30, compression=b"bz2")))

    def test_lengths_that_lie_end_with_a_message(self):
        self.look(b"#ROSBAG V2.0\n" + number(0xFFFFFFF0) + b"x" * 100)
        self.look(bag(message=EMPTY_CLOUD[:-6] + number(0xFFFFFFFF) + b"\0\0"))
        self.look(bag(size=0xFFFFFFF0), codes=(0, 1))

    def test_a_pipe_is_not_waited_for(self):
        os.mkfifo(self.path("r.bag"))
        self.assertIn("no record",
                      self.run_program("people", "--offline", "r.bag", codes=(1,)))

    def test_damaged_records_end_with_a_message(self):
        good = bag()
        for at in list(range(13, 80, 11)) + list(range(4109, len(good), 61)):
            self.look(good[:at] + bytes([good[at] ^ 0x55]) + good[at + 1:], codes=(0, 1))
            self.look(good[:at], codes=(0, 1))


def packed(content):
    """As zstd would, without making it smaller."""
    blocks = b"".join(
        struct.pack("<I", int(at + 0x20000 >= len(content)) | len(content[at:at + 0x20000]) << 3)[:3]
        + content[at:at + 0x20000] for at in range(0, len(content), 0x20000))
    return b"\x28\xb5\x2f\xfd\xe0" + struct.pack("<Q", len(content)) + blocks


def pose(x, y):
    return struct.pack("<12d", 1, 0, 0, 0, 1, 0, 0, 0, 1, x, y, 0)


def key_frame(x, y, points, distance=50.0):
    return (number(0) + pose(x, y) + struct.pack("<ddB3d247f", 0, distance, 0, 0, 0, 0, *[1.0] * 247)
            + number(len(points)) + b"".join(struct.pack("<3h", *point) for point in points)
            + number(0) + number(0))  # no clouds of cameras, no pictures


def slam_map(*key_frames, name=b"s"):
    return b"coppice slam map 3\n" + packed(
        number(1) + number(len(name)) + name + bytes(8) + number(len(key_frames))
        + b"".join(key_frames) + number(0))


class Maps(FileAttack):
    POINTS = [(200, 100 * i, 50) for i in range(-5, 5)]  # cm
    HALL = [(7 * i % 60000 - 30000, 11 * i % 60000 - 30000, 13 * i % 60000 - 30000)
            for i in range(30000)]  # without walls

    def paint(self, content, codes=(1,)):
        self.write("m.slam", content)
        return self.run_program("map", "m.slam", "--plan", "plan.jpg", codes=codes)

    def test_places_that_lie_kilometres_apart_are_not_painted(self):
        self.paint(slam_map(key_frame(0, 0, self.POINTS)), codes=(0,))
        for far in (2000, 3000, 1e300):
            self.paint(slam_map(key_frame(-far, -far, self.POINTS),
                                key_frame(far, far, self.POINTS)), codes=(0, 1))

    def test_a_hall_without_walls_takes_no_more_memory_than_there_is(self):
        self.assertIn("--memory", self.paint(slam_map(key_frame(0, 0, self.HALL, 1000.0))))

    def test_a_file_of_holes_beside_it_allows_no_more(self):
        os.mkdir(self.path("maps"))
        with open(self.path("maps/hollow"), "wb") as file:
            file.truncate(3 << 30)
        self.write("maps/map-000001.slam", slam_map(key_frame(0, 0, self.HALL, 1000.0)))
        self.assertIn("--memory", self.run_program("map", "maps", "--plan", "plan.jpg", codes=(1,)))

    def test_distances_that_are_none_are_damaged(self):
        for distance in (float("nan"), float("inf"), -1, 1e9):
            self.assertIn("damaged", self.paint(slam_map(key_frame(0, 0, self.POINTS, distance))))

    def test_damaged_maps_end_with_a_message(self):
        good = slam_map(key_frame(0, 0, self.POINTS), key_frame(1, 0, self.POINTS))
        for at in range(0, len(good), 181):
            self.paint(good[:at] + bytes([good[at] ^ 0x55]) + good[at + 1:], codes=(0, 1))
            self.paint(good[:at])

    def test_a_name_says_nothing_to_the_terminal(self):
        self.assertNotIn("\x1b", self.paint(slam_map(name=b"\x1b[2Jgone"), codes=(0, 1)))


class Answers(FileAttack):
    """Whoever stands at the page of the questionnaire cannot undo what others answered."""

    def answer(self, marks, host=None):
        base = "http://" + (host or "127.0.0.1") + ":%d" % self.port
        request = urllib.request.Request("http://127.0.0.1:%d/call" % self.port, marks.encode(),
                                         {"Origin": base, "Host": base[len("http://"):]})
        with urllib.request.urlopen(request, timeout=10) as reply:
            return reply.read().decode()

    def setUp(self):
        super().setUp()
        process = subprocess.Popen(
            [file_attack.PROGRAM, "questionnaire", "answers.csv", "--port", "0"], cwd=self.folder,
            stdout=subprocess.PIPE, text=True)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.terminate)
        self.port = int(re.search(r":(\d+)$", process.stdout.readline()).group(1))
        self.marks = '{"marks":[%s]}' % ",".join("3" * self.answer("").count('"low"'))

    def test_answers_that_have_become_too_many_stay(self):
        self.assertEqual(self.answer(self.marks), "{}")
        with open(self.path("answers.csv"), "ab") as file:
            file.write(b"\n" * (65 << 20))
        size = os.path.getsize(self.path("answers.csv"))
        self.assertIn("not written", self.answer(self.marks))
        self.assertEqual(os.path.getsize(self.path("answers.csv")), size)

    def test_a_page_of_somebody_else_cannot_answer_under_a_name_that_means_the_robot(self):
        with self.assertRaises(urllib.error.HTTPError) as refused:
            self.answer(self.marks, "rebound.example")
        self.assertEqual(refused.exception.code, 403)
        refused.exception.close()


if __name__ == "__main__":
    file_attack.PROGRAM = os.path.abspath(sys.argv.pop(1))
    file_attack.MEMORY = int(sys.argv.pop(1)) << 20  # bytes
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    del FileAttack
    unittest.main()
