"""Watches a running tree with a client that knows nothing but the Groot2 protocol.

usage: groot2_client_test.py LIVE_SERVER_PROGRAM
"""
import json
import os
import socket
import struct
import subprocess
import sys
import time
import unittest
import xml.etree.ElementTree as ElementTree

import msgpack
import zmq

TIMEOUT_MS = 20000
RUNNING, SUCCESS, FAILURE = 1, 2, 3


class Client:
    """One REQ socket and the header arithmetic of the protocol."""

    def __init__(self, port):
        self.socket = zmq.Context.instance().socket(zmq.REQ)
        self.socket.setsockopt(zmq.LINGER, 0)
        self.socket.setsockopt(zmq.RCVTIMEO, TIMEOUT_MS)
        self.socket.connect("tcp://127.0.0.1:%d" % port)

    def close(self):
        self.socket.close()

    def raw(self, *parts):
        self.socket.send_multipart(parts)
        return self.socket.recv_multipart()

    def ask(self, kind, *more):
        """The tree's id and the payload of a good reply."""
        number = struct.unpack("<I", os.urandom(4))[0]
        reply = self.raw(struct.pack("<BcI", 2, kind, number), *more)
        assert len(reply[0]) == 22, reply
        assert struct.unpack("<BcI", reply[0][:6]) == (2, kind, number), reply[0]
        return reply[0][6:], reply[1] if len(reply) > 1 else None

    def error(self, kind, *more):
        """The text of an error reply."""
        reply = self.raw(struct.pack("<BcI", 2, kind, 7), *more)
        assert len(reply) == 2 and reply[0] == b"error", reply
        return reply[1].decode()

    def statuses(self):
        payload = self.ask(b"S")[1]
        assert len(payload) % 3 == 0
        return dict(struct.unpack_from("<HB", payload, at) for at in range(0, len(payload), 3))


class Groot2ClientTest(unittest.TestCase):
    program = None

    def setUp(self):
        arguments = getattr(getattr(self, self._testMethodName), "arguments", [])
        self.server = subprocess.Popen([self.program] + arguments, stdin=subprocess.PIPE,
                                       stdout=subprocess.PIPE)
        self.port = int(self.server.stdout.readline().split()[0])
        self.client = self.connect()

    def listen(self):
        listener = zmq.Context.instance().socket(zmq.SUB)
        listener.setsockopt(zmq.LINGER, 0)
        listener.setsockopt(zmq.RCVTIMEO, TIMEOUT_MS)
        listener.setsockopt(zmq.SUBSCRIBE, b"")
        listener.connect("tcp://127.0.0.1:%d" % (self.port + 1))
        self.addCleanup(listener.close)
        self.wait_until_heard(listener)
        return listener

    def wait_until_heard(self, listener):
        """A subscription reaches the server when it does; what was published before is not heard.
        A replaced root is published with every tick until then."""
        self.client.ask(b"I", self.hook(1, mode=1, desired_status="SUCCESS"))
        self.notified(listener, 1)
        self.client.ask(b"A")

    def hook(self, uid, **more):
        hook = {"enabled": True, "uid": uid, "mode": 0, "once": False,
                "desired_status": "SKIPPED", "position": 0}
        hook.update(more)
        return json.dumps(hook).encode()

    def unlock(self, uid, status="SKIPPED", position=0, remove=False):
        return self.client.ask(b"U", json.dumps(
            {"uid": uid, "position": position, "desired_status": status,
             "remove_when_done": remove}).encode())

    def notified(self, listener, uid, client=None):
        """Until the breakpoint is published; keeps the heartbeat meanwhile."""
        deadline = time.monotonic() + TIMEOUT_MS / 1000
        while time.monotonic() < deadline:
            if not listener.poll(200):
                (client or self.client).ask(b"S")
                continue
            header, text = listener.recv_multipart()
            self.assertEqual((len(header), header[:2]), (6, b"\x02N"))
            if text == str(uid).encode():
                return
        self.fail("no notification of node %d" % uid)

    def ticks(self):
        return msgpack.unpackb(self.client.ask(b"B", b"Main")[1])["Main"]["number"]

    def wait_for(self, condition):
        deadline = time.monotonic() + TIMEOUT_MS / 1000
        while time.monotonic() < deadline:
            if condition():
                return
        self.fail("waited in vain")

    def expect_standing(self):
        before = self.ticks()
        for _ in range(20):
            self.client.ask(b"S")
            time.sleep(0.005)
        self.assertEqual(self.ticks(), before)

    def expect_running(self):
        before = self.ticks()
        self.wait_for(lambda: self.ticks() > before + 1)

    def connect(self):
        client = Client(self.port)
        self.addCleanup(client.close)
        return client

    def tearDown(self):
        rest, _ = self.server.communicate(timeout=20)  # closes its input
        self.assertEqual(self.server.returncode, 0)
        self.assertGreater(int(rest.split()[0]), 0)

    def tree(self):
        return ElementTree.fromstring(self.client.ask(b"T")[1].decode())

    def test_tree_joins_by_path_and_number(self):
        root = self.tree()
        self.assertEqual(root.get("BTCPP_format"), "4")
        trees = root.findall("BehaviorTree")
        self.assertEqual([(t.get("ID"), t.get("_fullpath")) for t in trees],
                         [("Main", ""), ("Inner", "inner")])
        nodes = [n for t in trees for n in t.iter() if n is not t]
        self.assertEqual(sorted(int(n.get("_uid")) for n in nodes), [1, 2, 3, 4, 5, 6])
        subtree = next(n for n in nodes if n.tag == "SubTree")
        self.assertEqual(subtree.get("_fullpath"), "inner")
        self.assertEqual(list(self.client.statuses()), [1, 2, 3, 4, 6, 5])

    def test_models_describe_every_node(self):
        root = self.tree()
        models = {m.get("ID"): m for m in root.find("TreeNodesModel")}
        for t in root.findall("BehaviorTree"):
            for node in list(t.iter())[1:]:
                self.assertIn(node.tag, models)
        self.assertEqual(models["Fill"].tag, "Action")
        port = next(p for p in models["Fill"] if p.get("name") == "text")
        self.assertEqual((port.tag, port.get("type"), port.text),
                         ("output_port", "string", 'a "quoted" text'))
        port = models["Alternate"].find("input_port")
        self.assertEqual(port.get("default"), "hello")
        self.assertEqual(models["Sequence"].tag, "Control")

    def test_statuses_follow_the_running_tree(self):
        seen = set()
        deadline = time.monotonic() + TIMEOUT_MS / 1000
        while seen != {10 + SUCCESS, 10 + FAILURE} and time.monotonic() < deadline:
            statuses = self.client.statuses()
            if statuses[1] == RUNNING:
                self.assertEqual(statuses[6], RUNNING)
                self.assertEqual(statuses[2], SUCCESS)
                seen.add(statuses[5])
        self.assertEqual(seen, {10 + SUCCESS, 10 + FAILURE})

    def test_blackboard_values_keep_their_types(self):
        first = msgpack.unpackb(self.client.ask(b"B", b"Main;inner;nobody")[1])
        self.assertEqual(set(first), {"Main", "inner"})
        main = first["Main"]
        number = main.pop("number")
        self.assertIsInstance(number, int)
        self.assertEqual(main, {"flag": True, "large": 1 << 40, "ratio": 0.5, "third": 1 / 3,
                                "text": "n\u00e4her & n\u00e4her", "spot": "3;-4"})
        self.assertEqual(first["inner"], {"literal": 7})
        deadline = time.monotonic() + TIMEOUT_MS / 1000
        now = number
        while now <= number and time.monotonic() < deadline:
            now = msgpack.unpackb(self.client.ask(b"B", b"Main")[1])["Main"]["number"]
        self.assertGreater(now, number)

    def test_unknown_board_is_nil(self):
        self.assertEqual(self.client.ask(b"B", b"nobody")[1], b"\xc0")

    def test_tree_id_is_a_constant_uuid(self):
        first, _ = self.client.ask(b"S")
        again, _ = self.connect().ask(b"T")
        self.assertEqual(first, again)
        self.assertEqual(first[6] >> 4, 4)
        self.assertEqual(first[8] >> 6, 2)

    def test_errors_have_two_parts(self):
        self.assertEqual(self.client.raw(b"x"), [b"error", b"wrong request header"])
        self.assertEqual(self.client.raw(b"\x02B1234"), [b"error", b"must be 2 parts message"])
        self.assertEqual(self.client.raw(b"\x02?1234"), [b"error", b"Request not recognized"])
        self.assertEqual(len(self.client.raw(b"\x01S1234", b"extra")[0]), 22)

    def test_every_error_has_its_text(self):
        for kind in (b"B", b"I", b"R", b"U", b"r"):
            self.assertEqual(self.client.error(kind), "must be 2 parts message")
        for kind in (b"I", b"R", b"U"):
            self.assertTrue(self.client.error(kind, b"{").startswith(
                "[json.exception.parse_error.101]"))
        self.assertIn("key 'uid' not found", self.client.error(b"R", b"{}"))
        self.assertTrue(self.client.error(b"R", b"{}").startswith(
            "[json.exception.out_of_range.403]"))
        self.assertTrue(self.client.error(b"I", b'{"enabled": 3}').startswith(
            "[json.exception.type_error.302]"))
        nowhere = b'{"uid": 2, "position": 0}'
        self.assertEqual(self.client.error(b"R", nowhere), "Node ID not found")
        unlock = b'{"uid": %d, "position": 0, "desired_status": "", "remove_when_done": false}'
        for uid in (2, 999):
            self.assertEqual(self.client.error(b"U", unlock % uid), "Node ID not found")
        for kind in (b"N", b"\0", b"Z"):
            self.assertEqual(self.client.error(kind), "Request not recognized")

    def test_a_breakpoint_stops_the_tree_until_it_is_unlocked(self):
        listener = self.listen()
        self.expect_running()
        self.assertEqual(self.client.ask(b"I", self.hook(3))[1], None)
        self.notified(listener, 3)
        self.expect_standing()
        statuses = self.client.statuses()
        self.assertEqual((statuses[1], statuses[2]), (RUNNING, SUCCESS))
        self.unlock(3)
        self.notified(listener, 3)
        self.unlock(3, remove=True)
        self.expect_running()
        self.assertEqual(json.loads(self.client.ask(b"D")[1]), [])

    def test_an_unlocked_breakpoint_can_decide_for_the_node(self):
        listener = self.listen()
        self.client.ask(b"I", self.hook(2))
        self.notified(listener, 2)
        self.unlock(2, "FAILURE")
        self.notified(listener, 2)
        self.assertEqual(self.client.statuses()[2], 10 + FAILURE)
        self.unlock(2, remove=True)

    def test_a_hook_behind_a_node_replaces_its_result(self):
        listener = self.listen()
        self.client.ask(b"I", self.hook(2, mode=1, desired_status="FAILURE", position=1))
        self.notified(listener, 2)
        self.wait_for(lambda: self.client.statuses()[1] == FAILURE)
        before = self.ticks()
        self.wait_for(lambda: self.ticks() > before)  # it is ticked nevertheless
        self.client.ask(b"R", b'{"uid": 2, "position": 1}')
        self.wait_for(lambda: self.client.statuses()[1] == RUNNING)

    def test_a_replaced_node_is_not_ticked(self):
        listener = self.listen()
        self.client.ask(b"I", self.hook(2, mode=1, desired_status="SUCCESS"))
        self.notified(listener, 2)
        before = self.ticks()
        for _ in range(5):
            self.notified(listener, 2)
        self.assertEqual(self.ticks(), before)
        self.client.ask(b"A")
        self.expect_running()

    def test_a_batch_is_dumped_as_it_was_inserted(self):
        hooks = [json.loads(self.hook(uid, enabled=False, position=uid % 2)) for uid in (2, 3, 999)]
        self.client.ask(b"I", json.dumps(hooks).encode())
        self.assertEqual(json.loads(self.client.ask(b"D")[1]), hooks[:2])
        self.client.ask(b"I", self.hook(2, mode=1, enabled=False, desired_status="SUCCESS"))
        dump = json.loads(self.client.ask(b"D")[1])
        self.assertEqual([(h["uid"], h["mode"]) for h in dump], [(2, 1), (3, 0)])
        self.client.ask(b"A")
        self.assertEqual(json.loads(self.client.ask(b"D")[1]), [])

    def test_a_hook_that_is_once_is_gone_afterwards(self):
        listener = self.listen()
        self.client.ask(b"I", self.hook(2, mode=1, once=True, desired_status="FAILURE"))
        self.notified(listener, 2)
        self.wait_for(lambda: json.loads(self.client.ask(b"D")[1]) == [])
        self.expect_running()

    def test_disabling_and_removing_let_the_tree_go_on(self):
        listener = self.listen()
        for release in ((b"X",), (b"A",), (b"R", b'{"uid": 3, "position": 0}')):
            self.client.ask(b"I", self.hook(3))
            self.notified(listener, 3)
            self.client.ask(*release)
            self.expect_running()

    def test_the_tree_goes_on_when_the_client_dies(self):
        listener = self.listen()
        other = self.connect()
        self.client.ask(b"I", self.hook(3))
        self.notified(listener, 3)
        died = time.monotonic()
        time.sleep(0.9)
        self.assertFalse(any(not h["enabled"] for h in json.loads(other.ask(b"D")[1])) and
                         time.monotonic() - died < 0.5)
        self.notified(listener, 3, other)  # enabled again by the request
    test_the_tree_goes_on_when_the_client_dies.arguments = ["deadline_ms=500"]

    def test_recording_keeps_every_transition(self):
        start = self.client.ask(b"r", b"start")[1]
        self.assertTrue(start.isdigit())
        self.assertLess(abs(int(start) / 1e6 - time.time()), 60)
        before = self.ticks()
        self.wait_for(lambda: self.ticks() > before + 20)
        self.assertIsNone(self.client.ask(b"r", b"stop")[1])
        self.assertIsNone(self.client.ask(b"r", b"nonsense")[1])
        payload = self.client.ask(b"t")[1]
        self.assertEqual(len(payload) % 9, 0)
        last, alternate = 0, []
        for at in range(0, len(payload), 9):
            microseconds = int.from_bytes(payload[at:at + 6], "little")
            uid, status = struct.unpack_from("<HB", payload, at + 6)
            self.assertGreaterEqual(microseconds, last)
            self.assertIn(status, range(4))
            last = microseconds
            if uid == 5 and status != 0:
                alternate.append(status)
        self.assertLess(last, 20e6)
        self.assertGreater(len(alternate), 15)
        self.assertTrue(all(a != b for a, b in zip(alternate, alternate[1:])), alternate)
        self.assertEqual(self.client.ask(b"t")[1], b"")

    def test_a_moving_robot_refuses_breakpoints_with_the_reason(self):
        self.assertEqual(self.client.error(b"I", self.hook(3)), "the robot moves")
        self.expect_running()
    test_a_moving_robot_refuses_breakpoints_with_the_reason.arguments = ["moving"]

    def test_old_protocol_number_is_answered_with_the_new_one(self):
        self.assertEqual(self.client.raw(b"\x01S1234")[0][0], 2)

    def test_notification_port_is_there(self):
        with socket.create_connection(("127.0.0.1", self.port + 1), timeout=20) as plain:
            self.assertEqual(plain.recv(1), b"\xff")  # greeting of ZeroMQ's transport

    def test_survives_garbage_on_the_wire(self):
        for garbage in (b"GET / HTTP/1.1\r\n\r\n", os.urandom(4096), b"\xff" * 64):
            with socket.create_connection(("127.0.0.1", self.port), timeout=20) as plain:
                plain.sendall(garbage)
        dealer = zmq.Context.instance().socket(zmq.DEALER)
        dealer.setsockopt(zmq.LINGER, 0)
        self.addCleanup(dealer.close)
        dealer.connect("tcp://127.0.0.1:%d" % self.port)
        dealer.send_multipart([b"no", b"envelope"])
        dealer.send_multipart([b"", b"\x02S1234"])
        self.assertEqual(dealer.poll(TIMEOUT_MS), zmq.POLLIN)
        self.assertEqual(len(self.client.statuses()), 6)


if __name__ == "__main__":
    Groot2ClientTest.program = sys.argv.pop(1)
    unittest.main()
