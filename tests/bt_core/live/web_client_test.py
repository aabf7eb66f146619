"""Watches a running tree over WebSocket with a client that knows nothing but docs/live.md and RFC 6455.

usage: web_client_test.py LIVE_SERVER_PROGRAM
"""
import base64
import hashlib
import json
import os
import select
import socket
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.error
import urllib.request

TIMEOUT = 20
TOKEN = "a token for this test"


class Refused(Exception):
    pass


class WebSocket:
    """One connection; messages are lists of parts."""

    def __init__(self, port, token=None, **fields):
        self.socket = socket.create_connection(("127.0.0.1", port), TIMEOUT)
        self.stream = self.socket.makefile("rb")
        key = base64.b64encode(os.urandom(16)).decode()
        protocols = "coppice-live" + (", token." + token if token else "")
        header = {"Host": "localhost:%d" % port, "Origin": "http://localhost:%d" % port,
                  "Upgrade": "websocket", "Connection": "keep-alive, Upgrade",
                  "Sec-WebSocket-Version": "13", "Sec-WebSocket-Key": key,
                  "Sec-WebSocket-Protocol": protocols}
        header.update({name.replace("_", "-"): value for name, value in fields.items()})
        lines = ["GET / HTTP/1.1"] + ["%s: %s" % field for field in header.items() if field[1]]
        self.socket.sendall("\r\n".join(lines + ["", ""]).encode())
        status = self.stream.readline().decode()
        answer = {}
        for line in iter(self.stream.readline, b"\r\n"):
            if not line:
                break
            name, value = line.decode().split(":", 1)
            answer[name.lower()] = value.strip()
        if " 101 " not in status:
            why = self.stream.read(int(answer.get("content-length", 0))).decode()
            self.close()
            raise Refused(status + why)
        accept = hashlib.sha1((key + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11").encode()).digest()
        assert answer["sec-websocket-accept"] == base64.b64encode(accept).decode()
        assert answer["sec-websocket-protocol"] == "coppice-live"

    def close(self):
        self.stream.close()
        self.socket.close()

    def send_frame(self, opcode, payload, final=True):
        mask = os.urandom(4)
        size = len(payload)
        length = (struct.pack(">B", 0x80 | size) if size < 126 else
                  struct.pack(">BH", 0xfe, size) if size < 1 << 16 else
                  struct.pack(">BQ", 0xff, size))
        masked = bytes(byte ^ mask[i % 4] for i, byte in enumerate(payload))
        self.socket.sendall(bytes([(0x80 if final else 0) | opcode]) + length + mask + masked)

    def receive_frame(self):
        """Opcode and payload; (None, b"") when the connection is closed."""
        try:
            head = self.stream.read(2)
        except ConnectionResetError:
            return None, b""
        if len(head) < 2:
            return None, b""
        assert not head[1] & 0x80, "a server masks nothing"
        size = head[1]
        if size >= 126:
            size, = struct.unpack(">H" if size == 126 else ">Q",
                                  self.stream.read(2 if size == 126 else 8))
        return head[0] & 0x0f, self.stream.read(size)

    def send(self, parts):
        self.send_frame(2, b"".join(struct.pack("<I", len(part)) + part for part in parts))

    def receive(self):
        message = b""
        while True:
            opcode, payload = self.receive_frame()
            if opcode in (None, 8):
                return None
            if opcode == 9:
                self.send_frame(10, payload)
            elif opcode in (0, 2):
                message += payload
                parts = unpack(message)
                if parts is not None:
                    return parts


def unpack(message):
    parts, at = [], 0
    while at < len(message):
        if at + 4 > len(message):
            return None
        size, = struct.unpack_from("<I", message, at)
        if at + 4 + size > len(message):
            return None
        parts.append(message[at + 4:at + 4 + size])
        at += 4 + size
    return parts


class WebClientTest(unittest.TestCase):
    program = None

    def setUp(self):
        method = getattr(self, self._testMethodName)
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        with open(self.folder.name + "/index.html", "w") as page:
            page.write("<title>the editor</title>")
        self.server = subprocess.Popen(
            [self.program, "web=" + self.folder.name] + getattr(method, "arguments", []),
            stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            env=dict(os.environ, **getattr(method, "environment", {})))
        words = self.server.stdout.readline().decode().split()
        self.port = int(words[1])
        self.tokens = words[2:]
        self.number = 0

    def tearDown(self):
        output, _ = self.server.communicate(timeout=TIMEOUT)
        self.assertEqual(self.server.returncode, 0)
        self.assertGreater(int(output.split()[0]), 0)

    def connect(self, *arguments, **fields):
        client = WebSocket(self.port, *arguments, **fields)
        self.addCleanup(client.close)
        return client

    def ask(self, client, do, **members):
        self.number += 1
        client.send([struct.pack("<BcI", 2, b"C", self.number),
                     json.dumps(dict(members, do=do)).encode()])
        while True:
            header, body = client.receive()
            if header[1:2] == b"C" and struct.unpack_from("<I", header, 2)[0] == self.number:
                return json.loads(body)

    def expect_ticking(self):
        client = self.connect(*self.tokens[1:2])
        self.ask(client, "hello", protocol=1)
        before = self.ask(client, "trees")["trees"][0]["tick"]
        deadline = time.monotonic() + TIMEOUT
        while self.ask(client, "trees")["trees"][0]["tick"] < before + 3:
            self.assertLess(time.monotonic(), deadline)

    def test_the_page_and_nothing_else_is_served(self):
        place = "http://localhost:%d" % self.port
        with urllib.request.urlopen(place + "/", timeout=TIMEOUT) as page:
            self.assertIn("text/html", page.headers["Content-Type"])
            self.assertEqual(page.headers["X-Frame-Options"], "DENY")
            self.assertIn(b"the editor", page.read())
        for path in ("/missing.html", "/../etc/passwd", "/etc/passwd"):
            with self.assertRaises(urllib.error.HTTPError) as refused:
                urllib.request.urlopen(place + path, timeout=TIMEOUT)
            self.assertEqual(refused.exception.code, 404)

    def test_requests_are_answered_and_frames_come(self):
        client = self.connect()
        hello = self.ask(client, "hello", protocol=1, name="browser")
        self.assertEqual((hello["protocol"], hello["role"]), (1, "control"))
        subscribed = self.ask(client, "subscribe", tree=0)
        following = subscribed["next"]
        while following < 60:
            header, body = client.receive()
            if header[1:2] != b"F":
                continue
            first, after = struct.unpack_from("<QQ", body)
            self.assertEqual(header[6:], bytes.fromhex(subscribed["run"]))
            self.assertEqual(first, following)
            following = after
            client.send([struct.pack("<BcI", 2, b"C", 0),
                         json.dumps({"do": "ack", "subscription": 1, "next": after}).encode()])

    def test_a_message_may_come_in_fragments_and_with_pings_between(self):
        client = self.connect()
        request = json.dumps({"do": "hello", "protocol": 1}).encode()
        message = (struct.pack("<I", 6) + struct.pack("<BcI", 2, b"C", 7) +
                   struct.pack("<I", len(request)) + request)
        client.send_frame(2, message[:9], final=False)
        client.send_frame(9, b"are you there")
        client.send_frame(0, message[9:])
        self.assertEqual(client.receive_frame(), (10, b"are you there"))
        self.assertEqual(struct.unpack_from("<I", client.receive()[0], 2)[0], 7)

    def test_what_a_client_holds_is_released_when_its_page_is_closed(self):
        client = self.connect()
        self.ask(client, "hello", protocol=1)
        self.ask(client, "pause")
        client.close()
        self.expect_ticking()
    test_what_a_client_holds_is_released_when_its_page_is_closed.arguments = [
        "deadline_ms=3600000"]

    def test_pages_of_others_are_refused(self):
        for fields in ({"Origin": "http://evil.example"}, {"Origin": "null"},
                       {"Host": "evil.example", "Origin": "http://evil.example"},
                       {"Sec_WebSocket_Protocol": None}):
            with self.assertRaisesRegex(Refused, "403"):
                self.connect(**fields)
        self.connect(Origin=None)

    def test_tokens_open_what_they_are_for(self):
        _, control, read = self.tokens
        for wrong in (None, "x" * 32, read[:-1], TOKEN, self.tokens[0]):
            with self.assertRaisesRegex(Refused, "403"):
                self.connect(wrong)
        reader = self.connect(read, Host="robot:1", Origin="http://robot:1")
        self.assertEqual(self.ask(reader, "hello", protocol=1)["role"], "read")
        self.assertEqual(self.ask(reader, "pause")["role"], "control")
        self.assertEqual(self.ask(self.connect(control), "hello", protocol=1)["role"], "control")
    test_tokens_open_what_they_are_for.environment = {"COPPICE_LIVE_TOKEN": TOKEN}

    def test_nonsense_closes_its_own_connection_only(self):
        watcher = self.connect()
        self.ask(watcher, "hello", protocol=1)
        for frames in ([(2, b"no parts")], [(1, b"text")], [(2, b"")], [(3, b"reserved")],
                       [(8, b"\x03")], [(9, b"x" * 126)], [(0, b"continues nothing")],
                       [(2, struct.pack("<I", 1 << 31))], [(2, b"x" * ((1 << 20) + 1))]):
            client = self.connect()
            try:
                for opcode, payload in frames:
                    client.send_frame(opcode, payload)
            except (BrokenPipeError, ConnectionResetError):
                pass
            self.assertIsNone(client.receive(), frames[0][1][:20])
        unmasked = self.connect()
        unmasked.socket.sendall(b"\x82\x01x")
        self.assertIsNone(unmasked.receive())
        self.assertEqual(self.ask(watcher, "ping"), {})
        self.expect_ticking()

    def test_of_too_many_strangers_those_who_came_first_give_way(self):
        crowd = [socket.create_connection(("127.0.0.1", self.port), TIMEOUT) for _ in range(256 + 16)]
        closed = set()
        while len(closed) < 16:
            ready, _, _ = select.select([one for one in crowd if one not in closed], [], [], TIMEOUT)
            self.assertTrue(ready, f"only {len(closed)} were closed")
            for one in ready:
                self.assertEqual(one.recv(1), b"")
                closed.add(one)
        self.assertEqual(closed, set(crowd[:16]))
        watcher = self.connect()  # though the port is full
        self.ask(watcher, "hello", protocol=1)
        for one in crowd:
            one.close()


if __name__ == "__main__":
    WebClientTest.program = sys.argv.pop(1)
    unittest.main()
