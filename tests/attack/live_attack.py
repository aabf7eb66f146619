"""Does to `coppice run --live --web` what an attacker did, with and without a token.

usage: live_attack.py COPPICE
"""
import base64
import json
import os
import re
import socket
import struct
import subprocess
import sys
import tempfile
import time
import unittest

import zmq

TOKEN = "0123456789abcdef-attack"
PATIENCE = 20  # s, for what must happen
MEMORY = 256 << 20  # bytes: no more may ever be taken
SLOWNESS = 1  # of a program that is watched by a sanitizer: times as long, and as large

TREE = """<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence name="top">
  <Sleep msec="20"/><AlwaysSuccess/></Sequence></BehaviorTree></root>"""


LARGE_TREE = TREE.replace("<AlwaysSuccess/>", "<AlwaysSuccess/>" * 20_000)


class Robot:
    """`coppice run`, and what it printed of its doors."""

    def __init__(self, program, token=None, content=TREE, more={}, options=()):
        self.folder = tempfile.TemporaryDirectory()
        tree = os.path.join(self.folder.name, "tree.xml")
        with open(tree, "w") as file:
            file.write(content)
        environment = dict(os.environ, **more)
        environment.pop("COPPICE_LIVE_TOKEN", None)
        if token:
            environment["COPPICE_LIVE_TOKEN"] = token
        self.process = subprocess.Popen(
            [program, "run", tree, "--forever", "--quiet", "--live", "--live-port", "0", "--web",
             "--web-port", "0", *options], env=environment, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True)
        printed = ""
        while printed.count("://") < (2 if token else 1):
            line = self.process.stdout.readline()
            assert line, "the program ended: " + printed
            printed += line
        self.port = int(re.search(r"127\.0\.0\.1:(\d+)", printed).group(1))
        self.web_port = int(re.search(r"://127\.0\.0\.1:(\d+)", printed).group(1))
        self.web_tokens = re.findall(r"://[^ #]*#([0-9a-f]+)", printed)  # control, read
        self.read_token = (re.search(r"read-[0-9a-f]+", printed) or [None])[0]

    def memory(self):
        with open("/proc/%d/status" % self.process.pid) as file:
            return int(re.search(r"VmHWM:\s+(\d+)", file.read()).group(1)) << 10

    def descriptors(self):
        return len(os.listdir("/proc/%d/fd" % self.process.pid))

    def close(self):
        self.process.terminate()
        self.process.wait(PATIENCE)
        self.process.stdout.close()
        self.folder.cleanup()


class Client:
    def __init__(self, port, identity=None, keys=None):
        self.socket = zmq.Context.instance().socket(zmq.DEALER)
        self.socket.setsockopt(zmq.LINGER, 0)
        if identity and not identity.startswith(b"\0"):
            self.socket.setsockopt(zmq.IDENTITY, identity)
        if keys:
            self.socket.curve_publickey, self.socket.curve_secretkey = keys[:2]
            self.socket.curve_serverkey = keys[2]
        self.socket.connect("tcp://127.0.0.1:%d" % port)

    def ask(self, **request):
        self.socket.send_multipart([b"", struct.pack("<BcI", 2, b"C", 7),
                                    json.dumps(request).encode()])
        while self.socket.poll(PATIENCE * 1000):
            _, header, body = self.socket.recv_multipart()
            if header[1:2] == b"C":
                return json.loads(body)
        raise AssertionError("no answer to %s" % request)

    def close(self):
        self.socket.close()


def frame(flags, body):
    if len(body) > 255:
        return struct.pack(">BQ", flags | 2, len(body)) + body
    return struct.pack(">BB", flags, len(body)) + body


def talk(port, identity=b"", kind=b"DEALER"):
    """A connection that has said who it is, without libzmq, which would not take every identity."""
    properties = b"\x0bSocket-Type" + struct.pack(">I", len(kind)) + kind
    properties += b"\x08Identity" + struct.pack(">I", len(identity)) + identity
    greeting = b"\xff" + bytes(8) + b"\x7f\x03\x00" + b"NULL".ljust(20, b"\0") + bytes(32)
    connection = socket.create_connection(("127.0.0.1", port), PATIENCE)
    connection.sendall(greeting + frame(4, b"\x05READY" + properties))
    return connection


def opened(port, kind=b"DEALER"):
    connection = talk(port, kind=kind)
    assert read_until(connection, b"PUB" if kind == b"SUB" else b"ROUTER")
    return connection


def request(body, what=b"C"):
    return frame(1, b"") + frame(1, struct.pack("<BcI", 2, what, 7)) + frame(0, body)


def read_until(connection, wanted):
    """What came until then; nothing if the connection ended first."""
    heard = bytearray()
    looked_at = 0
    while heard.find(wanted, looked_at) < 0:
        looked_at = max(0, len(heard) - len(wanted))
        part = connection.recv(65536)
        if not part:
            return b""
        heard += part
    return bytes(heard)


def send_until_closed(connection, piece, limit):
    """The bytes that were taken before the robot hung up."""
    sent = 0
    try:
        while sent < limit:
            connection.sendall(piece)
            sent += len(piece)
    except OSError:
        pass
    return sent


def web_socket(port, token=None):
    connection = socket.create_connection(("127.0.0.1", port), PATIENCE)
    protocols = "coppice-live" + (", token." + token if token else "")
    connection.sendall(("GET / HTTP/1.1\r\nHost: localhost:%d\r\nUpgrade: websocket\r\n"
                        "Connection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                        "Sec-WebSocket-Key: %s\r\nSec-WebSocket-Protocol: %s\r\n\r\n" %
                        (port, base64.b64encode(bytes(16)).decode(), protocols)).encode())
    assert b" 101 " in read_until(connection, b"\r\n\r\n")
    return connection


def web_message(body, what=b"C"):
    header = struct.pack("<BcI", 2, what, 7)
    message = struct.pack("<I", 6) + header
    if body:
        message += struct.pack("<I", len(body)) + body
    return struct.pack(">BB", 0x82, 0x80 | len(message)) + bytes(4) + message


class WithRobot(unittest.TestCase):
    token = None
    tree = TREE
    environment = {}

    def setUp(self):
        self.robot = Robot(PROGRAM, self.token, self.tree, self.environment)
        self.addCleanup(self.robot.close)

    def connect(self, **options):
        client = Client(self.robot.port, **options)
        self.addCleanup(client.close)
        return client

    def assert_serves(self, within=2.0):
        """An honest client is answered, at once."""
        begin = time.monotonic()
        client = self.connect()
        self.assertEqual(client.ask(do="hello")["protocol"], 1)
        self.assertLess(time.monotonic() - begin, SLOWNESS * within)
        self.assertIsNone(self.robot.process.poll(), "the tree's process ended")


class Identities(WithRobot):
    def test_a_client_with_the_identity_that_the_next_one_would_get_ends_nothing(self):
        # rand() of libzmq 4.3.4 is never seeded: its first number is known.
        hostile = [talk(self.robot.port, b"\0" + struct.pack(">I", (0x6b8b4567 + i) % 2**32))
                   for i in range(64)]
        for connection in hostile:
            self.assertIn(b"READY", read_until(connection, b"ROUTER"))
        for _ in range(3):
            self.assert_serves()

    def test_who_takes_the_identity_of_a_controller_has_nothing_of_its_session(self):
        owner = talk(self.robot.port, b"\0\x6b\x8b\x45\x67")
        owner.sendall(request(b'{"do":"hello"}'))
        self.assertIn(b"control", read_until(owner, b"trees"))
        thief = talk(self.robot.port, b"\0\x6b\x8b\x45\x67")
        thief.sendall(request(b'{"do":"pause"}'))
        self.assertIn(b"say hello first", read_until(thief, b"}"))
        owner.close()
        thief.sendall(request(b'{"do":"pause"}'))
        self.assertIn(b"say hello first", read_until(thief, b"}"))

    def test_the_session_of_a_browser_is_out_of_reach(self):
        browser = web_socket(self.robot.web_port)
        browser.sendall(web_message(b'{"do":"hello"}'))
        self.assertIn(b"control", read_until(browser, b"trees"))
        for number in range(1, 5):
            thief = talk(self.robot.port, b"\0web%d" % number)
            thief.sendall(request(b'{"do":"pause"}'))
            self.assertIn(b"say hello first", read_until(thief, b"}"))
            thief.sendall(request(b'{"do":"bye"}'))
            self.assertIn(b"say hello first", read_until(thief, b"}"))
        browser.sendall(web_message(b'{"do":"ping"}'))
        self.assertIn(b"{}", read_until(browser, b"}"))


class Memory(WithRobot):
    def test_a_message_without_end_is_cut_off(self):
        piece = frame(1, b"x" * 60_000) * 4
        sent = send_until_closed(opened(self.robot.port), piece, 512 << 20)
        self.assertLess(sent, 16 << 20)
        listener = opened(self.robot.port + 1, kind=b"SUB")
        self.assertLess(send_until_closed(listener, piece, 64 << 20), 16 << 20)
        self.assert_serves()
        self.assertLess(self.robot.memory(), MEMORY)

    def test_a_web_request_without_end_is_cut_off(self):
        chunked = b"POST / HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\n"
        for begin in (b"GET /", b"GET / HTTP/1.1\r\nA: ", chunked, chunked + b"1;",
                      chunked + b"0\r\nA: "):
            browser = socket.create_connection(("127.0.0.1", self.robot.web_port), PATIENCE)
            browser.sendall(begin)
            self.assertLess(send_until_closed(browser, b"0" * 65536, 64 << 20), 16 << 20, begin)
        self.assert_serves()
        self.assertLess(self.robot.memory(), MEMORY)

    def test_a_request_of_20_mb_is_cut_off_before_it_is_read(self):
        body = b'{"do":"hello","x":[' + b"[]," * 6_700_000 + b"0]}"
        sent = send_until_closed(opened(self.robot.port), request(body), 1)
        browser = web_socket(self.robot.web_port)
        message = struct.pack(">BBQ", 0x82, 0x80 | 127, len(body)) + bytes(4) + body
        sent += send_until_closed(browser, message, 1)
        self.assertEqual(sent, 0)
        self.assert_serves()
        self.assertLess(self.robot.memory(), MEMORY)

    def test_requests_faster_than_they_can_be_served_hold_up_nobody(self):
        body = b'{"do":"hello","x":[' + b"[]," * 20_000 + b"0]}"
        piece = request(body)
        crowd = [opened(self.robot.port) for _ in range(20)]
        for connection in crowd:
            connection.setblocking(False)
        end = time.monotonic() + 4
        while time.monotonic() < end:
            for connection in crowd:
                try:
                    connection.send(piece)  # answers are not read
                except OSError:
                    pass
        self.assert_serves(within=4.0)
        self.assertLess(self.robot.memory(), MEMORY)

    def test_answers_that_nobody_reads_are_not_kept_without_end(self):
        crowd = [opened(self.robot.port) for _ in range(64)]
        for connection in crowd:
            connection.setblocking(False)
        piece = request(b"", b"T") * 50
        end = time.monotonic() + 3
        while time.monotonic() < end:
            for connection in crowd:
                try:
                    connection.send(piece)
                except OSError:
                    pass
        self.assert_serves(within=4.0)
        self.assertLess(self.robot.memory(), MEMORY)


class Page(unittest.TestCase):
    def test_a_large_file_that_nobody_reads_is_not_kept_for_each_who_asks(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "index.html"), "w") as file:
                file.write("<p>here</p>")
            with open(os.path.join(folder, "large.js"), "wb") as file:
                file.truncate(20 << 20)
            robot = Robot(PROGRAM, options=("--web-folder", folder))
            self.addCleanup(robot.close)
            crowd = []
            for _ in range(64):
                browser = socket.socket()
                browser.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
                browser.settimeout(PATIENCE)
                browser.connect(("127.0.0.1", robot.web_port))
                browser.sendall(b"GET /large.js HTTP/1.1\r\nHost: localhost\r\n\r\n" * 8)
                crowd.append(browser)
                self.addCleanup(browser.close)
            for browser in crowd:  # it is on its way to all of them
                self.assertIn(b" 200 OK", read_until(browser, b"\r\n\r\n"))
            reader = socket.create_connection(("127.0.0.1", robot.web_port), PATIENCE)
            self.addCleanup(reader.close)
            reader.sendall(b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n")
            self.assertTrue(read_until(reader, b"<p>here</p>"))
            self.assertLess(robot.memory(), SLOWNESS * 64 << 20)


class LargeTree(WithRobot):
    tree = LARGE_TREE

    def test_crowds_that_follow_a_large_tree_and_do_not_read_take_little(self):
        crowd = [opened(self.robot.port) for _ in range(63)]
        for connection in crowd:
            connection.sendall(request(b'{"do":"hello"}'))
            for _ in range(16):
                connection.sendall(request(b'{"do":"subscribe","window":67108864}'))
        self.assert_serves()
        self.assertLess(self.robot.memory(), MEMORY)


class LongLine(WithRobot):
    """A file of megabytes without a line's end."""
    tree = TREE.replace("<AlwaysSuccess/>", '<AlwaysSuccess name="%s"/>' % ("x" * 400) * 20_000)

    def test_the_text_of_a_tree_in_one_long_line_keeps_nobody_waiting(self):
        asks = opened(self.robot.port)
        asks.sendall(request(b"", b"T"))
        self.assert_serves()
        self.assertIn(b"</root>", read_until(asks, b"</root>"))
        self.assertLess(self.robot.memory(), MEMORY)


class LargeTreeWithToken(WithRobot):
    token = TOKEN
    tree = LARGE_TREE
    environment = {"MALLOC_PERTURB_": "165"}  # memory that was given back is not what it was

    def test_readers_that_are_pushed_out_while_they_wait_end_nothing(self):
        control, read = self.robot.web_tokens
        ask = web_message(b"", b"T") * 3
        for _ in range(3):
            crowd = [web_socket(self.robot.web_port, read) for _ in range(256)]
            for reader in crowd:
                reader.sendall(ask)
            others = [web_socket(self.robot.web_port, read) for _ in range(60)]
            for reader in crowd + others:
                reader.close()
        browser = web_socket(self.robot.web_port, control)
        browser.sendall(web_message(b'{"do":"hello"}'))
        self.assertIn(b'"role":"control"', read_until(browser, b"trees"))
        self.assertIsNone(self.robot.process.poll())

    def test_what_those_ask_who_hang_up_at_once_keeps_nobody_waiting(self):
        control, read = self.robot.web_tokens
        end = time.monotonic() + 2
        while time.monotonic() < end:
            reader = web_socket(self.robot.web_port, read)
            reader.sendall(web_message(b"", b"T"))
            reader.close()
        browser = web_socket(self.robot.web_port, control)
        begin = time.monotonic()
        browser.sendall(web_message(b'{"do":"hello"}'))
        self.assertIn(b'"role":"control"', read_until(browser, b"trees"))
        self.assertLess(time.monotonic() - begin, 2 * SLOWNESS)
        self.assertLess(self.robot.memory(), MEMORY)


class Connections(WithRobot):
    def test_a_thousand_that_say_nothing_take_neither_descriptors_nor_clients(self):
        silent = []
        for port in (self.robot.port, self.robot.port + 1, self.robot.web_port):
            for _ in range(330):
                silent.append(socket.create_connection(("127.0.0.1", port), PATIENCE))
        self.addCleanup(lambda: [connection.close() for connection in silent])
        self.assert_serves()
        browser = web_socket(self.robot.web_port)
        browser.close()
        self.assertLess(self.robot.descriptors(), 600)

    def test_nonsense_and_broken_off_greetings_end_nothing(self):
        pieces = [b"", b"GET / HTTP/1.1\r\n\r\n", bytes(200), b"\xff" * 64,
                  b"\xff" + bytes(8) + b"\x7f\x01\x00", b"\xff" + bytes(8) + b"\x7f\x03\x00CURVE"]
        for piece in pieces * 20:
            connection = socket.create_connection(("127.0.0.1", self.robot.port), PATIENCE)
            connection.sendall(piece)
            connection.close()
        self.assert_serves()


class Token(WithRobot):
    """A robot with a token: strangers get nothing, readers do not control."""
    token = TOKEN

    def keys(self):
        """Of the reader, as docs/live.md says: its secret and the robot's public key."""
        from hashlib import blake2b
        data = bytes.fromhex(self.robot.read_token[len("read-"):])
        secret = blake2b(data[:16], digest_size=32).digest()
        encode = zmq.utils.z85.encode
        public = zmq.curve_public(encode(secret))
        return public, encode(secret), encode(data[16:])

    def test_a_reader_may_not_control_under_whatever_identity(self):
        for identity in (None, b"web1", b"controller"):
            reader = self.connect(identity=identity, keys=self.keys())
            self.assertEqual(reader.ask(do="hello")["role"], "read")
            for attempt in ({"do": "pause"}, {"do": "hook", "node": 0}, {"do": "continue"},
                            {"do": "write", "key": "x", "value": 1}):
                self.assertEqual(reader.ask(**attempt).get("role"), "control", attempt)

    def test_a_reader_stays_one_while_a_browser_controls(self):
        reader = self.connect(keys=self.keys())
        reader.ask(do="hello")
        self.assertEqual(reader.ask(do="pause").get("role"), "control")
        self.assertEqual(reader.ask(do="ping"), {})

    def test_readers_leave_room_for_who_may_control(self):
        control, read = self.robot.web_tokens
        readers = [web_socket(self.robot.web_port, read) for _ in range(300)]
        for reader in readers:
            try:
                reader.sendall(web_message(b'{"do":"hello"}'))
            except OSError:
                pass  # it gave way already
        self.addCleanup(lambda: [reader.close() for reader in readers])
        browser = web_socket(self.robot.web_port, control)
        browser.sendall(web_message(b'{"do":"hello"}'))
        self.assertIn(b'"role":"control"', read_until(browser, b"trees"))

    def test_who_does_not_know_it_is_not_served(self):
        stranger = talk(self.robot.port)
        stranger.sendall(request(b'{"do":"hello"}'))
        self.assertEqual(read_until(stranger, b"protocol"), b"")
        reader = self.connect(keys=self.keys())
        self.assertEqual(reader.ask(do="hello")["role"], "read")

    def test_strangers_in_the_handshake_keep_nobody_out(self):
        silent = [socket.create_connection(("127.0.0.1", self.robot.port), PATIENCE)
                  for _ in range(400)]
        self.addCleanup(lambda: [connection.close() for connection in silent])
        reader = self.connect(keys=self.keys())
        self.assertEqual(reader.ask(do="hello")["role"], "read")


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    SLOWNESS = int(sys.argv.pop(1))
    MEMORY *= SLOWNESS
    import zmq.utils.z85
    unittest.main(warnings="ignore")
