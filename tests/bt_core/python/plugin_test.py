"""Leaves in Python and in C++ in one tree."""
import os

import pytest

import coppice
from coppice import SUCCESS, Output, Registry, SyncAction

PLUGIN = os.environ["COPPICE_PLUGIN"]


class Gives(SyncAction):
    number: Output[float]

    def run(self):
        self.number = 3.0
        return SUCCESS


def test_a_leaf_in_python_gives_a_leaf_in_a_plugin_its_number():
    registry = Registry([Gives])
    registry.load_plugin(PLUGIN)
    tree = coppice.loads("""<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence>
        <Gives number="{n}"/><Half number="{n}" half="{h}"/></Sequence></BehaviorTree></root>""",
                         registry)
    assert tree.tick() == SUCCESS
    assert tree["h"] == 1.5


def test_a_file_that_is_no_plugin_is_told(tmp_path):
    (tmp_path / "no.so").write_text("nothing")
    with pytest.raises(RuntimeError, match="no.so"):
        Registry().load_plugin(tmp_path / "no.so")
