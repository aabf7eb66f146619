"""Trees: load, check, tick, run, and their keys."""
import math
import threading

import pytest

import coppice
from coppice import (FAILURE, IDLE, RUNNING, SUCCESS, Action, Condition, Input, SimulatedClock,
                     SyncAction)


def xml(inside):
    return ('<root BTCPP_format="4"><BehaviorTree ID="Main">\n' + inside
            + '</BehaviorTree></root>')


class IsDark(Condition):
    lux: Input[float] = Input("brightness", unit="lx")

    def check(self):
        return self.lux < 10


class Hold(Action):
    """Runs until it is halted."""
    def __init__(self, log=None):
        self.log = [] if log is None else log

    def on_start(self):
        self.log.append("start")
        return RUNNING

    def on_running(self):
        return RUNNING

    def on_halted(self):
        self.log.append("halt")


def test_all_problems_are_told_with_place_and_hint():
    with pytest.raises(coppice.LoadError) as error:
        coppice.loads(xml('<Sequense>\n<IsDark luxx="{lux}"/></Sequense>'), [IsDark], file="a.xml")
    sequense, luxx = error.value.diagnostics[:2]
    assert (sequense.file, sequense.line, sequense.column) == ("a.xml", 2, 1)
    assert sequense.hint == 'did you mean "Sequence"?'
    assert str(error.value).count("a.xml:") == len(error.value.diagnostics)


def test_a_literal_of_a_wrong_type_is_found_at_load():
    problems = coppice.checks(xml('<IsDark lux="bright"/>'), [IsDark])
    assert [p.line for p in problems if p.is_error] == [2]


def test_a_file_that_is_not_there_is_an_error():
    with pytest.raises(coppice.LoadError, match="nowhere.xml"):
        coppice.load("nowhere.xml")


def test_check_without_leaves_does_not_ask_for_them():
    assert not [p for p in coppice.checks(xml('<Unknown/>')) if p.is_error]


def test_check_with_leaves_knows_all():
    assert [p for p in coppice.checks(xml('<Unknown/>'), []) if p.is_error]


def test_a_class_in_place_of_a_list_is_told():
    with pytest.raises(TypeError, match=r"\[IsDark\]"):
        coppice.loads(xml("<IsDark lux='1'/>"), IsDark)


def test_keys_are_written_and_read():
    tree = coppice.loads(xml('<IsDark lux="{lux}"/>'), [IsDark])
    assert "lux" not in tree and tree.get("lux", 5) == 5
    tree["lux"] = 3
    assert tree["lux"] == 3.0 and "lux" in tree and list(tree) == ["lux"]
    assert tree.tick() == SUCCESS


def test_a_misspelt_key_is_told_with_the_right_one():
    tree = coppice.loads(xml('<IsDark lux="{brightness}"/>'), [IsDark])
    with pytest.raises(KeyError, match='did you mean "brightness"?'):
        tree["brigthness"] = 3
    with pytest.raises(KeyError, match='did you mean "brightness"?'):
        tree["brigthness"]


def test_a_key_without_value_is_an_error_to_read():
    tree = coppice.loads(xml('<IsDark lux="{lux}"/>'), [IsDark])
    with pytest.raises(KeyError, match="has no value yet"):
        tree["lux"]


def test_a_key_of_another_type_is_refused():
    tree = coppice.loads(xml('<IsDark lux="{lux}"/>'), [IsDark])
    with pytest.raises(TypeError, match='key "lux": expected float, not str'):
        tree["lux"] = "dark"


def test_a_write_does_not_take_away_a_timer():
    clock = SimulatedClock()
    tree = coppice.loads(xml('<Sequence><Sleep msec="1000"/><SetBlackboard value="1" '
                             'output_key="k"/></Sequence>'), clock=clock)
    tree.tick()
    tree["k"] = "2"
    assert tree.next_tick == 1.0


def test_run_on_simulated_time_takes_the_time_that_the_tree_needs():
    clock = SimulatedClock()
    tree = coppice.loads(xml('<Sleep msec="3600000"/>'), clock=clock)
    assert tree.run() == SUCCESS
    assert clock.now() == 3600


def test_a_clock_does_not_go_beyond_its_end():
    clock = SimulatedClock(9e9)
    with pytest.raises(ValueError, match="292 years"):
        clock.advance(1e9)
    assert clock.now() == 9e9


def test_nodes_have_status_and_place():
    tree = coppice.loads(xml('<Sequence name="all">\n<Hold name="hold"/></Sequence>'), [Hold])
    tree.tick()
    node = tree.node("hold")
    assert (node.id, node.status, node.line) == ("Hold", RUNNING, 3)


def test_a_misspelt_node_is_told_with_the_right_name():
    tree = coppice.loads(xml('<Hold name="hold"/>'), [Hold])
    with pytest.raises(KeyError, match='did you mean "hold"?'):
        tree.node("hodl")


def test_stop_from_another_thread_halts_the_leaves():
    log = []
    registry = coppice.Registry()
    registry.register(Hold, log)
    tree = coppice.loads(xml("<Hold/>"), registry)
    runner = threading.Thread(target=tree.run)
    runner.start()
    while tree.status != RUNNING:
        pass
    tree.stop()
    assert log == ["start", "halt"] and tree.status == IDLE
    runner.join()


def test_two_threads_cannot_tick_one_tree():
    tree = coppice.loads(xml("<Hold/>"), [Hold])
    runner = threading.Thread(target=tree.run)
    runner.start()
    while not tree.is_running:
        pass
    with pytest.raises(RuntimeError, match="another thread ticks this tree"):
        tree.tick()
    tree.stop()
    runner.join()


def test_keys_go_to_and_fro_while_another_thread_runs():
    tree = coppice.loads(xml('<Sequence><KeepRunningUntilFailure><Script code="b := a + 1"/>'
                             '</KeepRunningUntilFailure></Sequence>'))
    tree["a"] = 1
    runner = threading.Thread(target=tree.run, kwargs={"period": 0.001})
    runner.start()
    for a in range(2, 50):
        tree["a"] = a
        while tree.get("b") != a + 1:
            pass
    tree.stop()
    runner.join()


def test_many_threads_at_one_tree_do_no_harm():
    tree = coppice.loads(xml('<KeepRunningUntilFailure><Script code="b := a + 1"/>'
                             '</KeepRunningUntilFailure>'))
    tree["a"] = 1
    refused = []

    def use(k):
        for _ in range(200):
            tree["a"] = k
            tree.get("b")
            tree.nodes
            try:
                tree.tick()
            except RuntimeError as error:
                refused.append(str(error))
    threads = [threading.Thread(target=use, args=(k,)) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert set(refused) <= {"another thread ticks this tree"}
    assert tree.tick() == RUNNING


def test_a_leaf_cannot_tick_its_own_tree():
    class Selfish(SyncAction):
        def run(self):
            return tree.tick()
    tree = coppice.loads(xml("<Selfish/>"), [Selfish], on_exception="raise")
    with pytest.raises(RuntimeError, match="cannot tick, run or halt the tree that it is in"):
        tree.tick()


def test_with_raise_the_exception_of_the_leaf_comes_out_itself():
    raised = ValueError("mine")

    class Breaks(SyncAction):
        def run(self):
            raise raised
    tree = coppice.loads(xml("<Breaks/>"), [Breaks], on_exception="raise")
    with pytest.raises(ValueError) as error:
        tree.tick()
    assert error.value is raised


def test_with_fail_the_tree_goes_on():
    class Breaks(SyncAction):
        def run(self):
            raise ValueError("mine")
    tree = coppice.loads(xml("<Fallback><Breaks/><AlwaysSuccess/></Fallback>"), [Breaks])
    assert tree.tick() == SUCCESS


def test_a_wrong_policy_is_told():
    with pytest.raises(ValueError, match='not "ignore"'):
        coppice.loads(xml("<AlwaysSuccess/>"), on_exception="ignore")


def test_an_exception_in_init_comes_out_of_load():
    class Breaks(SyncAction):
        def __init__(self):
            raise OSError("no such device")
    with pytest.raises(OSError, match="no such device"):
        coppice.loads(xml("<Breaks/>"), [Breaks])


def test_exit_in_a_leaf_halts_the_others_and_comes_out():
    log = []

    class Exits(SyncAction):
        def run(self):
            raise SystemExit(3)
    registry = coppice.Registry([Exits])
    registry.register(Hold, log)
    tree = coppice.loads(xml('<Parallel success_count="2"><Hold/><Exits/></Parallel>'), registry)
    with pytest.raises(SystemExit):
        tree.run()
    assert log == ["start", "halt"]


def test_a_fixed_rate_needs_a_period():
    tree = coppice.loads(xml("<AlwaysSuccess/>"))
    with pytest.raises(ValueError, match="positive period"):
        tree.run(period=0, fixed_rate=True)


@pytest.mark.parametrize("period", [math.nan, 1e30])
def test_a_period_that_is_no_time_is_refused(period):
    tree = coppice.loads(xml("<AlwaysSuccess/>"))
    with pytest.raises(ValueError, match="is no time in seconds"):
        tree.run(period=period)


def test_a_registry_may_grow_without_the_tree():
    registry = coppice.Registry()
    tree = coppice.loads(xml("<AlwaysFailure/>"), registry)
    registry.register(IsDark)
    del registry
    assert tree.tick() == FAILURE


def test_a_tree_is_shown_as_a_picture():
    tree = coppice.loads(xml('<Sequence><IsDark name="dark" lux="{lux}"/></Sequence>'), [IsDark])
    picture = tree._repr_svg_()
    if picture is None:  # the editor was not built
        pytest.importorskip("coppice_editor")
    assert picture.startswith("<") and "dark" in picture and "{lux}" in picture
