"""Records of runs: as iterables, as tables, and asked why."""
import pytest

import coppice
from coppice import SUCCESS, Output, Status, SyncAction


class Breaks(SyncAction):
    def run(self):
        raise ValueError("no such place")


class Gives(SyncAction):
    place: Output[dict]
    number: Output[int]

    def run(self):
        self.place = {"x": 1}
        self.number = 7
        return SUCCESS


XML = """<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence name="all">
<Gives place="{place}" number="{number}"/><Fallback><Breaks name="breaks"/><AlwaysSuccess/></Fallback>
</Sequence></BehaviorTree></root>"""


@pytest.fixture
def record(tmp_path):
    tree = coppice.loads(XML, [Breaks, Gives])
    with tree.record(tmp_path / "run.coppice", {"robot": "sobi-1"}) as recorder:
        tree.tick()
        recorder.note("test", "between two ticks")
        tree.tick()
    return coppice.open_record(tmp_path / "run.coppice")


def test_the_ticks_come_in_order(record):
    assert [tick.number for tick in record] == [1, 2] and len(record) == 2


def test_a_tick_has_changes_writes_and_messages(record):
    tick = next(iter(record))
    assert tick.result == SUCCESS
    assert ("breaks", Status.IDLE, Status.FAILURE) in tick.changes
    assert ("number", 7, "Gives::2") in tick.writes
    assert tick.messages[0].node == "breaks"


def test_the_traceback_is_in_the_record(record):
    text = next(iter(record)).messages[0].text
    assert text.startswith("Traceback") and text.endswith("ValueError: no such place")


def test_the_traceback_is_the_answer_to_why(record):
    assert "ValueError: no such place" in record.why("breaks")


def test_a_misspelt_node_is_told_with_the_right_name(record):
    with pytest.raises(KeyError, match="breaks"):
        record.why("braeks")


def test_a_tick_behind_the_end_is_told(record):
    with pytest.raises(IndexError, match="the record ends with tick 2"):
        record.why("breaks", tick=99)


def test_what_the_program_said_is_there(record):
    assert record.metadata == {"robot": "sobi-1"} and record.is_closed
    assert record.main_tree == "Main" and ("breaks", "Breaks") in record.nodes


def test_the_tables_are_those_of_pandas(record):
    pandas = pytest.importorskip("pandas")
    changes = record.changes_frame()
    assert isinstance(changes, pandas.DataFrame)
    assert (changes[changes.node == "breaks"].after == "FAILURE").sum() == 2
    assert list(record.ticks_frame().tick) == [1, 2]
    assert set(record.writes_frame().key) == {"place", "number"}
    assert len(record.messages_frame()) == 2


def test_the_figures_of_a_node_are_there(record):
    figures = {node["node"]: node for node in record.statistics()["nodes"]}
    assert figures["breaks"]["ticks"] == 2


def test_a_file_that_is_no_record_is_an_error(tmp_path):
    (tmp_path / "no.coppice").write_text("nothing")
    with pytest.raises(ValueError, match="no.coppice"):
        coppice.open_record(tmp_path / "no.coppice")


def test_a_record_that_nobody_holds_goes_on(tmp_path):
    tree = coppice.loads(XML, [Breaks, Gives])
    tree.record(tmp_path / "run.coppice")
    tree.tick()
    del tree
    assert coppice.open_record(tmp_path / "run.coppice").is_closed


def test_a_leaf_cannot_record_its_own_tree(tmp_path):
    class Records(SyncAction):
        def run(self):
            tree.record(tmp_path / "run.coppice")
            return SUCCESS
    tree = coppice.loads('<root BTCPP_format="4"><BehaviorTree ID="Main"><Records/></BehaviorTree>'
                         '</root>', [Records], on_exception="raise")
    with pytest.raises(RuntimeError, match="cannot be done within a tick"):
        tree.tick()


def test_a_record_that_is_there_is_not_overwritten(tmp_path):
    (tmp_path / "run.coppice").write_text("mine")
    tree = coppice.loads(XML, [Breaks, Gives])
    with pytest.raises(RuntimeError, match="run.coppice"):
        tree.record(tmp_path / "run.coppice")
    assert (tmp_path / "run.coppice").read_text() == "mine"
