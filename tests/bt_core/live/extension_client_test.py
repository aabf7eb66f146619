"""Watches and debugs a running tree with a client that knows nothing but docs/live.md.

usage: extension_client_test.py LIVE_SERVER_PROGRAM
"""
import json
import os
import struct
import subprocess
import sys
import time
import unittest

import zmq

TIMEOUT_MS = 20000
TREE, STATE, EVENTS, GAP, NOTE, END = range(1, 7)


def crc32c(data):
    crc = 0xffffffff
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = (crc >> 1) ^ (0x82f63b78 if crc & 1 else 0)
    return crc ^ 0xffffffff


def split_frames(data, check=False):
    """The types of the frames, whose checksums are right."""
    types, at = [], 0
    while at < len(data):
        size, kind, crc = struct.unpack_from("<IBI", data, at)
        if check:
            covered = data[at:at + 5] + data[at + 9:at + 9 + size]
            assert crc32c(covered) == crc
        types.append(kind)
        at += 9 + size
    assert at == len(data)
    return types


class Client:
    def __init__(self, port, curve=None):
        self.socket = zmq.Context.instance().socket(zmq.DEALER)
        self.socket.setsockopt(zmq.LINGER, 0)
        if curve:
            self.socket.curve_publickey, self.socket.curve_secretkey, server = curve
            self.socket.curve_serverkey = server
        self.socket.connect("tcp://127.0.0.1:%d" % port)
        self.number = 0
        self.pushes, self.notices = [], []

    def close(self):
        self.socket.close()

    def send(self, number, request):
        self.socket.send_multipart([b"", struct.pack("<BcI", 2, b"C", number),
                                    json.dumps(request).encode()])

    def receive(self, timeout_ms=TIMEOUT_MS):
        """One message; pushes and notices are kept. The number and body of a reply."""
        if not self.socket.poll(timeout_ms):
            return None
        parts = self.socket.recv_multipart()
        assert parts[0] == b"", parts
        if parts[1] == b"error":
            return None, {"error": parts[2].decode()}
        assert len(parts) == 3 and len(parts[1]) == 22 and parts[1][0] == 2, parts[1]
        kind, number = struct.unpack("<cI", parts[1][1:6])
        if kind == b"F":
            first, following = struct.unpack_from("<QQ", parts[2])
            self.pushes.append((number, parts[1][6:], first, following, parts[2][16:]))
        elif kind == b"E":
            self.notices.append(json.loads(parts[2]))
        else:
            assert kind == b"C", kind
            return number, json.loads(parts[2])
        return ()

    def ask(self, do, **members):
        self.number += 1
        self.send(self.number, dict(members, do=do))
        deadline = time.monotonic() + TIMEOUT_MS / 1000
        while time.monotonic() < deadline:
            reply = self.receive()
            if reply and reply[0] in (self.number, None):
                return reply[1]
        raise AssertionError("no reply to " + do)

    def notice(self, event):
        """The next notice of that kind, keeping alive meanwhile."""
        deadline = time.monotonic() + TIMEOUT_MS / 1000
        while time.monotonic() < deadline:
            while self.notices:
                notice = self.notices.pop(0)
                if notice["event"] == event:
                    return notice
            if self.receive(100) is None:
                self.ask("ping")
        raise AssertionError("no notice " + event)

    def push(self):
        deadline = time.monotonic() + TIMEOUT_MS / 1000
        while not self.pushes and time.monotonic() < deadline:
            self.receive(100)
        return self.pushes.pop(0)


class ExtensionClientTest(unittest.TestCase):
    program = None

    def setUp(self):
        method = getattr(self, self._testMethodName)
        environment = dict(os.environ, **getattr(method, "environment", {}))
        self.server = subprocess.Popen([self.program] + getattr(method, "arguments", []),
                                       stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                       env=environment)
        words = self.server.stdout.readline().decode().split()
        self.port = int(words[0])
        self.read_token = words[2] if len(words) > 2 else None

    def connect(self, hello=True, curve=None):
        client = Client(self.port, curve)
        self.addCleanup(client.close)
        if hello:
            client.greeting = client.ask("hello", protocol=1, name="test")
        return client

    def tearDown(self):
        if self.server.poll() is None:
            self.server.communicate(timeout=20)
        self.assertEqual(self.server.returncode, 0)

    def tick(self, client):
        return client.ask("trees")["trees"][0]["tick"]

    def expect_running(self, client):
        before = self.tick(client)
        deadline = time.monotonic() + TIMEOUT_MS / 1000
        while self.tick(client) < before + 3:
            self.assertLess(time.monotonic(), deadline)

    def test_hello_tells_what_there_is(self):
        hello = self.connect().greeting
        self.assertEqual((hello["protocol"], hello["role"], hello["control"]),
                         (1, "control", True))
        self.assertEqual(hello["deadline_ms"], 5000)
        tree = hello["trees"][0]
        self.assertEqual((tree["tree"], tree["name"], tree["nodes"]), (0, "Main", 6))
        self.assertEqual(len(bytes.fromhex(tree["run"])), 16)
        self.assertIsNone(tree["stop"])

    def test_hello_comes_first_and_errors_are_texts(self):
        client = self.connect(hello=False)
        self.assertEqual(client.ask("trees")["error"], "say hello first")
        client.ask("hello", protocol=1)
        self.assertIn("no request", client.ask("dance")["error"])
        self.assertIn("there is no tree 7", client.ask("statistics", tree=7)["error"])
        client.socket.send_multipart([b"", b"\x02C\x09\0\0\0", b"{"])
        self.assertIn("parse error", client.receive()[1]["error"])
        client.socket.send_multipart([b"", b"\x02C\x09\0\0\0"])
        self.assertEqual(client.receive(), (None, {"error": "must be 2 parts message"}))
        client.socket.send_multipart([b"", b"\x02C\x09\0\0\0", b"[" * 10000])
        self.assertIn("nested too deep", client.receive()[1]["error"])

    def test_a_request_with_number_0_gets_no_reply_unless_it_fails(self):
        client = self.connect()
        client.send(0, {"do": "ping"})
        client.send(0, {"do": "ack", "subscription": 9, "next": 1})
        self.assertEqual(client.receive(), (0, {"error": "there is no subscription 9"}))

    def test_frames_come_without_a_hole(self):
        client = self.connect()
        reply = client.ask("subscribe", tree=0)
        self.assertEqual((reply["subscription"], reply["missed"]), (1, 0))
        run = bytes.fromhex(reply["run"])
        types, following = [], reply["next"]
        while following < 60:
            subscription, of_run, first, after, frames = client.push()
            self.assertEqual((subscription, of_run, first), (1, run, following))
            here = split_frames(frames, check=True)
            types += here
            self.assertEqual(after - first, len(here) - (TREE in here))
            following = after
            client.send(0, {"do": "ack", "subscription": 1, "next": following})
        self.assertEqual(types[:3], [TREE, STATE, EVENTS])
        self.assertEqual(set(types[2:]), {EVENTS})

    def test_who_comes_back_goes_on_where_it_was(self):
        client = self.connect()
        run = client.ask("subscribe")["run"]
        after = client.push()[3]
        client.ask("bye")
        again = self.connect()
        reply = again.ask("subscribe", run=run, **{"from": after})
        self.assertEqual((reply["next"], reply["missed"]), (after, 0))
        _, _, first, _, frames = again.push()
        self.assertEqual(first, after)
        self.assertEqual(split_frames(frames)[0], EVENTS)

    def test_another_run_begins_with_what_is_kept(self):
        client = self.connect()
        reply = client.ask("subscribe", run="00" * 16, **{"from": 5})
        self.assertEqual(reply["missed"], 0)
        self.assertEqual(split_frames(client.push()[4])[:2], [TREE, STATE])
        now = client.ask("subscribe", **{"from": "now"})
        self.assertEqual(now["subscription"], 2)
        with_error = client.ask("subscribe", **{"from": -3})
        self.assertIn("from: expected a whole number", with_error["error"])

    def test_a_slow_client_gets_a_gap(self):
        client = self.connect()
        client.ask("subscribe", window=1)
        _, _, _, after, _ = client.push()
        deadline = time.monotonic() + TIMEOUT_MS / 1000
        while client.ask("trees")["trees"][0]["first_frame"] <= after:
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)
        self.assertEqual(client.pushes, [])
        client.ask("ack", subscription=1, next=after)
        _, _, first, _, frames = client.push()
        self.assertGreater(first, after)
        self.assertEqual(split_frames(frames)[:2], [GAP, TREE])
        client.ask("ack", subscription=1, next=first)
        self.assertEqual(split_frames(client.push()[4])[0], STATE)
    test_a_slow_client_gets_a_gap.arguments = ["history_kib=1"]

    def test_the_last_frame_says_that_the_run_has_ended(self):
        client = self.connect()
        client.ask("subscribe", **{"from": "now"})
        client.push()
        self.server.stdin.close()
        types = []
        while END not in types:
            types += split_frames(client.push()[4])
        self.server.stdin = open(os.devnull)

    def test_a_stopped_tree_does_not_hold_up_the_end_of_its_program(self):
        client = self.connect()
        client.ask("hook", node="last")
        self.assertEqual(client.notice("stopped")["stop"]["where"], "before")
        self.server.communicate(timeout=20)
    test_a_stopped_tree_does_not_hold_up_the_end_of_its_program.arguments = [
        "deadline_ms=3600000"]

    def test_pause_step_and_continue(self):
        client = self.connect()
        self.assertEqual(client.ask("pause"), {})
        stop = client.notice("stopped")["stop"]
        self.assertEqual(stop["where"], "between_ticks")
        client.ask("step", to="node")
        stop = client.notice("stopped")["stop"]
        self.assertEqual((stop["where"], stop["node"]), ("before", 0))
        self.assertEqual(stop["path"], client.ask("hooks")["stop"]["path"])
        client.ask("step", to="tick")
        self.assertEqual(client.notice("stopped")["stop"]["where"], "between_ticks")
        self.assertIn("expected", client.ask("step", to="moon")["error"])
        client.ask("continue")
        client.notice("resumed")
        self.expect_running(client)

    def test_a_breakpoint_by_path_with_condition_and_hits(self):
        client = self.connect()
        path = "last"
        reply = client.ask("hook", node=path, condition="number > 3", from_hit=2)
        self.assertNotIn("error", reply)
        stop = client.notice("stopped")["stop"]
        self.assertEqual((stop["where"], stop["node"], stop["hook"]), ("before", 5, reply["hook"]))
        hook = client.ask("hooks")["hooks"][0]
        self.assertEqual((hook["nodes"], hook["mine"], hook["acted"]), ([5], True, 1))
        client.ask("continue", result="FAILURE")
        self.assertEqual(client.notice("stopped")["stop"]["node"], 5)
        self.assertEqual(client.ask("unhook", hook=reply["hook"]), {})
        self.expect_running(client)
        self.assertIn("there is no hook", client.ask("unhook", hook=reply["hook"])["error"])
        self.assertIn("error", client.ask("hook", node=5, condition="number >"))

    def test_a_path_that_is_not_there_waits_and_says_so(self):
        reply = self.connect().ask("hook", node="lost")
        self.assertIn("lost", reply["remark"])

    def test_faults_are_injected_as_often_as_asked(self):
        client = self.connect()
        client.ask("hook", node=1, position="after", action="replace", status="FAILURE", times=3)
        for _ in range(3):
            stop = client.notice("replaced")["stop"]
            self.assertEqual((stop["node"], stop["result"]), (1, "FAILURE"))
        deadline = time.monotonic() + TIMEOUT_MS / 1000
        while client.ask("hooks")["hooks"]:
            self.assertLess(time.monotonic(), deadline)
        self.expect_running(client)

    def test_a_value_is_written_with_its_type(self):
        client = self.connect()
        self.assertEqual(client.ask("write", scope="inner", key="literal", text="8"), {})
        self.assertIn("no int", client.ask("write", key="number", value="many")["error"])
        self.assertIn("has no key", client.ask("write", key="nothing", value=1)["error"])
        self.assertEqual(client.ask("write", key="number", value=7), {})

    def test_statistics_count_results(self):
        client = self.connect()
        self.expect_running(client)
        reply = client.ask("statistics")
        running, success, failure, skipped = reply["nodes"][4]  # Alternate
        self.assertEqual((running, skipped), (0, 0))
        self.assertLessEqual(abs(success - failure), 1)
        self.assertGreater(success, 0)

    def test_who_dies_releases_the_tree(self):
        watcher = self.connect()
        client = self.connect()
        client.ask("pause")
        client.notice("stopped")
        client.close()
        watcher.notice("stopped")
        watcher.notice("resumed")
        self.expect_running(watcher)
    test_who_dies_releases_the_tree.arguments = ["deadline_ms=600"]

    def test_who_is_silent_is_told(self):
        client = self.connect()
        deadline = time.monotonic() + TIMEOUT_MS / 1000
        while not client.notices and time.monotonic() < deadline:
            client.receive(100)
        self.assertEqual(client.notices[0]["event"], "released")
        self.assertEqual(client.ask("ping")["error"], "say hello first")
    test_who_is_silent_is_told.arguments = ["deadline_ms=300"]

    def test_the_first_tick_waits_for_a_client(self):
        client = self.connect()
        self.assertEqual(self.tick(client), 0)
        client.ask("hook", node=0, times=1)
        client.ask("continue")
        stop = client.notice("stopped")["stop"]
        while stop["where"] == "between_ticks":
            stop = client.notice("stopped")["stop"]
        self.assertEqual((stop["tick"], stop["node"]), (1, 0))
        client.ask("continue")
        self.expect_running(client)
    test_the_first_tick_waits_for_a_client.arguments = ["wait_ms=60000"]

    def test_the_first_tick_does_not_wait_for_ever(self):
        self.expect_running(self.connect())
    test_the_first_tick_does_not_wait_for_ever.arguments = ["wait_ms=200"]

    def test_two_trees_at_one_endpoint(self):
        client = self.connect()
        trees = client.greeting["trees"]
        self.assertEqual([t["name"] for t in trees], ["Main", "companion"])
        self.assertNotEqual(trees[0]["run"], trees[1]["run"])
        reply = client.ask("subscribe", tree=1)
        self.assertEqual(reply["run"], trees[1]["run"])
        client.push()
        client.ask("pause", tree=1)
        self.assertEqual(client.notice("stopped")["tree"], 1)
        self.expect_running(client)
    test_two_trees_at_one_endpoint.arguments = ["two"]

    def test_read_only_refuses_all_control(self):
        client = self.connect()
        self.assertIn("read-only", client.greeting["control"])
        for request in ({"do": "pause"}, {"do": "step"}, {"do": "hook", "node": 1},
                        {"do": "write", "key": "number", "value": 1}, {"do": "continue"},
                        {"do": "unhook"}):
            reply = client.ask(**request)
            self.assertEqual(reply["reason"], "refused", request)
        self.expect_running(client)
    test_read_only_refuses_all_control.arguments = ["read_only"]

    def test_a_moving_robot_gives_its_reason(self):
        reply = self.connect().ask("pause")
        self.assertEqual(reply, {"error": "the robot moves", "reason": "refused"})
    test_a_moving_robot_gives_its_reason.arguments = ["moving"]

    def keys(self, token):
        """As docs/live.md describes them: public and secret key of the client, key of the robot."""
        import nacl.bindings as sodium
        import nacl.pwhash.argon2id as argon2id

        def pair(secret):
            return zmq_key(sodium.crypto_scalarmult_base(secret)), zmq_key(secret)

        def blake(text, key=b""):
            return sodium.crypto_generichash_blake2b_salt_personal(text, 32, key)

        def zmq_key(key):
            import zmq.utils.z85
            return zmq.utils.z85.encode(key)

        if token.startswith("read-"):
            raw = bytes.fromhex(token[5:])
            return pair(blake(raw[:16])) + (zmq_key(raw[16:]),)
        seed = argon2id.kdf(32, token.encode(), b"coppice-live-v1\0", opslimit=2,
                            memlimit=64 << 20)
        return pair(blake(b"control", seed)) + (pair(blake(b"server", seed))[0],)

    def test_a_token_opens_the_door_and_the_read_token_only_to_watch(self):
        reader = self.connect(curve=self.keys(self.read_token))
        self.assertEqual(reader.greeting["role"], "read")
        reply = reader.ask("pause")
        self.assertEqual(reply["role"], "control")
        reader.ask("subscribe")
        reader.push()
        owner = self.connect(curve=self.keys("a token for this test"))
        self.assertEqual(owner.greeting["role"], "control")
        self.assertEqual(owner.ask("pause"), {})
        owner.notice("stopped")
        owner.ask("continue")
        _, _, robot = self.keys(self.read_token)
        stranger = self.connect(hello=False, curve=zmq.curve_keypair() + (robot,))
        plain = self.connect(hello=False)
        for client in (stranger, plain):
            client.send(1, {"do": "hello", "protocol": 1})
        self.expect_running(owner)
        for client in (stranger, plain):
            self.assertIsNone(client.receive(300))
    test_a_token_opens_the_door_and_the_read_token_only_to_watch.environment = {
        "COPPICE_LIVE_TOKEN": "a token for this test"}


if __name__ == "__main__":
    ExtensionClientTest.program = sys.argv.pop(1)
    unittest.main()
