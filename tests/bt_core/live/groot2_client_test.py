"""Watches a running tree with a client that knows nothing but the Groot2 protocol.

usage: groot2_client_test.py LIVE_SERVER_PROGRAM
"""
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
        return reply[0][6:], reply[1]

    def statuses(self):
        payload = self.ask(b"S")[1]
        assert len(payload) % 3 == 0
        return dict(struct.unpack_from("<HB", payload, at) for at in range(0, len(payload), 3))


class Groot2ClientTest(unittest.TestCase):
    program = None

    def setUp(self):
        self.server = subprocess.Popen([self.program], stdin=subprocess.PIPE,
                                       stdout=subprocess.PIPE)
        self.port = int(self.server.stdout.readline())
        self.client = self.connect()

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
        for kind in b"IRUDAXrt":
            reply = self.client.raw(b"\x02" + bytes([kind]) + b"1234", b"{}")
            self.assertEqual(reply[0], b"error")
            self.assertIn(b"not supported", reply[1])
        self.assertEqual(len(self.client.raw(b"\x01S1234", b"extra")[0]), 22)

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
