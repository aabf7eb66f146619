"""A reader of records that was written from docs/record_format.md alone, with Python and the zstd
library; it must find what the recording program says.

usage: record_reader_test.py PROGRAM    (bt_core_record_sample)
"""
import ctypes
import glob
import os
import re
import struct
import subprocess
import sys
import tempfile

TREE, STATE, EVENTS, GAP, NOTE, END = range(1, 7)
IDLE, RUNNING = 0, 1


class ZstdStream:
    """Unpacks pieces one after the other."""

    class Buffer(ctypes.Structure):
        _fields_ = [("data", ctypes.c_void_p), ("size", ctypes.c_size_t), ("pos", ctypes.c_size_t)]

    library = ctypes.CDLL("libzstd.so.1")
    library.ZSTD_createDStream.restype = ctypes.c_void_p
    library.ZSTD_decompressStream.restype = ctypes.c_size_t
    library.ZSTD_decompressStream.argtypes = [ctypes.c_void_p] + 2 * [ctypes.POINTER(Buffer)]

    def __init__(self):
        self.context = self.library.ZSTD_createDStream()

    def unpack(self, piece):
        room = ctypes.create_string_buffer(1 << 16)
        source = self.Buffer(ctypes.cast(ctypes.c_char_p(piece), ctypes.c_void_p), len(piece), 0)
        result = b""
        while True:
            target = self.Buffer(ctypes.cast(room, ctypes.c_void_p), len(room), 0)
            code = self.library.ZSTD_decompressStream(
                self.context, ctypes.byref(target), ctypes.byref(source))
            assert not self.library.ZSTD_isError(ctypes.c_size_t(code)), "damaged"
            result += room.raw[:target.pos]
            if source.pos == source.size and target.pos < target.size:
                return result


def crc32c(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc = crc >> 8 ^ CRC_TABLE[(crc ^ byte) & 0xFF]
    return crc ^ 0xFFFFFFFF


def crc_table():
    for value in range(256):
        for _ in range(8):
            value = value >> 1 ^ (0x82F63B78 if value & 1 else 0)
        yield value


CRC_TABLE = list(crc_table())


def zigzag(number):
    return number >> 1 ^ -(number & 1)


class Bytes:
    def __init__(self, data):
        self.data = data
        self.at = 0

    def take(self, count):
        assert self.at + count <= len(self.data), "cut off"
        self.at += count
        return self.data[self.at - count:self.at]

    def byte(self):
        return self.take(1)[0]

    def unsigned(self):
        number = shift = 0
        while True:
            byte = self.byte()
            number |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80:
                return number

    def signed(self):
        return zigzag(self.unsigned())

    def text(self):
        return self.take(self.unsigned())

    def list(self, read):
        return [read() for _ in range(self.unsigned())]

    def rest(self):
        return self.take(len(self.data) - self.at)

    def at_end(self):
        return self.at == len(self.data)


def frames(data):
    assert data[:8] == b"\x89Coppic\n" and data[8:12] == struct.pack("<I", 2)
    at = 12
    while at < len(data):
        size, kind, checksum = struct.unpack_from("<IBI", data, at)
        payload = data[at + 9:at + 9 + size]
        assert crc32c(data[at:at + 5] + payload) == checksum, "checksum"
        yield kind, payload
        at += 9 + size


class Tree:
    def __init__(self, data):
        self.writer = data.text()
        self.run = data.take(16)
        self.clock = data.text()
        self.start = data.signed()
        self.wall_start = data.signed()
        self.metadata = data.list(lambda: (data.text(), data.text()))
        self.main_tree = data.text()
        self.documents = data.list(lambda: (data.text(), data.text()))
        self.models = data.text()
        self.parents, self.one_child = [], []
        data.list(lambda: self.node(data))
        self.slots = data.list(lambda: (data.text(), data.text(), data.text(), data.byte()))
        assert data.at_end()

    def node(self, data):
        data.text()  # path
        data.text()  # ID
        self.one_child.append(data.byte() >= 128)
        self.parents.append(data.unsigned())
        data.unsigned()  # document
        data.unsigned()  # element
        data.list(lambda: (data.text(), data.unsigned()))

    def is_below(self, node, ancestor):
        while node > ancestor:
            node = self.parents[node]
        return node == ancestor


class Reader:
    """Follows a record; `lines` are what the recording program prints."""

    def __init__(self):
        self.lines = []
        self.notes = []
        self.states = 0
        self.closed = False

    def read(self, path):
        with open(path, "rb") as file:
            for kind, payload in frames(file.read()):
                self.frame(kind, Bytes(payload))

    def frame(self, kind, data):
        if kind == TREE:
            self.tree = Tree(Bytes(ZstdStream().unpack(data.rest())))
        elif kind == STATE:
            self.state(data)
        elif kind == EVENTS:
            ticks = Bytes(self.stream.unpack(data.rest()))
            while not ticks.at_end():
                self.one_tick(ticks)
        elif kind == NOTE:
            data.signed()
            self.notes.append((data.text(), data.text()))
        elif kind == END:
            self.closed = data.byte() == 0
        else:
            raise AssertionError("a gap")

    def state(self, data):
        data.byte()  # cause
        self.tick = data.unsigned()
        self.time = data.signed()
        self.step = 0
        self.stream = ZstdStream()
        body = Bytes(self.stream.unpack(data.rest()))
        statuses = [byte & 15 for byte in body.take(len(self.tree.parents))]
        values = [body.text() for _ in self.tree.slots]
        assert body.at_end()
        if self.states > 0 and len(statuses) == len(self.statuses):
            assert statuses == self.statuses and values == self.values, "not what it came to"
        self.statuses, self.values = statuses, values
        self.states += 1

    def one_tick(self, data):
        head = data.byte()
        step = head >> 4
        self.tick += data.signed() if step == 2 else step
        self.step += data.signed()
        self.time += self.step
        data.unsigned()  # duration
        events = Bytes(data.text())
        self.node = self.slot = 0
        self.ticked_child = {}
        while not events.at_end():
            self.event(events)
        result = head & 7
        self.lines.append("tick %d %d %d%s" % (self.tick, self.time, result,
                                               " halt" if result == IDLE else ""))
        self.lines.append("state " + " ".join(
            [str(status) for status in self.statuses] + [value.hex() for value in self.values]))

    def event(self, data):
        token = data.unsigned()
        code, step = token & 7, zigzag(token >> 3)
        if code in (5, 6):
            self.slot += step
            if code == 5:
                writer = data.unsigned()
                if writer > 0:
                    self.node += zigzag(writer - 1)
            self.values[self.slot] = data.text()
            return
        self.node += step
        if code == 7:
            data.unsigned()
            data.text()
        else:
            self.status(self.node, code)

    def status(self, node, status):
        nodes = range(node + 1, len(self.statuses))
        if status != RUNNING:
            idle = [i for i in nodes if self.tree.is_below(i, node)]
        elif self.tree.one_child[node] and node in self.ticked_child:
            child = self.ticked_child[node]
            idle = [i for i in nodes if i > child and self.tree.is_below(i, node) and
                    not self.tree.is_below(i, child)]
        else:
            idle = []
        for i in idle:
            self.statuses[i] = IDLE
        self.statuses[node] = status
        if status != IDLE:
            self.ticked_child[self.tree.parents[node]] = node


def number_of(path):
    found = re.search(r"\.(\d+)\.coppice$", path)
    return int(found.group(1)) if found else 1


def main():
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "run.coppice")
        printed = subprocess.run([sys.argv[1], path], stdout=subprocess.PIPE, check=True, text=True)
        files = sorted(glob.glob(os.path.join(folder, "*.coppice")), key=number_of)
        reader = Reader()
        for file in files:
            reader.read(file)
    # The program prints no state between a halt and the tick that follows it.
    expected = printed.stdout.splitlines()
    found = [line for i, line in enumerate(reader.lines)
             if i == 0 or not reader.lines[i - 1].endswith("halt")]
    assert len(files) > 2 and reader.states > len(files)
    assert reader.closed and len(reader.notes) == 8
    assert reader.tree.clock == b"simulated" and b"<root" in reader.tree.documents[0][1]
    for line, (a, b) in enumerate(zip(expected, found)):
        assert a == b, "line %d: expected\n%s\nfound\n%s" % (line, a, b)
    assert len(expected) == len(found), (len(expected), len(found))
    print("%d lines from %d files agree" % (len(found), len(files)))


main()
