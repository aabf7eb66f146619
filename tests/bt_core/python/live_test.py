"""The live view of a tree in Python, as `coppice live` sees it."""
import json
import os
import subprocess

import pytest

import coppice
from coppice import SyncAction

XML = """<root BTCPP_format="4"><BehaviorTree ID="Main">
<Fallback><Breaks name="breaks"/><AlwaysSuccess/></Fallback></BehaviorTree></root>"""


class Breaks(SyncAction):
    def run(self):
        raise ValueError("no such place")


def test_who_watches_sees_ticks_and_tracebacks():
    tree = coppice.loads(XML, [Breaks])
    with tree.live(port=0) as live:
        watcher = subprocess.Popen([os.environ["COPPICE"], "live", f"127.0.0.1:{live.port}", "--json"],
                                   stdout=subprocess.PIPE, text=True)
        texts = []
        for line in watcher.stdout:
            told = json.loads(line)
            if told["type"] == "state":  # it is there
                tree.tick()
            texts += [message["text"] for message in told.get("messages", [])]
            if texts:
                break
        watcher.terminate()
        watcher.wait()
    assert texts[0].endswith("ValueError: no such place")


def test_a_port_that_is_taken_is_an_error():
    tree = coppice.loads(XML, [Breaks])
    with tree.live(port=0) as live:
        with pytest.raises(RuntimeError, match=str(live.port)):
            coppice.loads(XML, [Breaks]).live(live.port)


def test_others_than_this_computer_need_a_token():
    tree = coppice.loads(XML, [Breaks])
    with pytest.raises(ValueError, match="token"):
        tree.live(port=0, address="*")


def test_a_closed_view_serves_nobody():
    tree = coppice.loads(XML, [Breaks])
    live = tree.live(port=0)
    live.close()
    assert live.port == 0
