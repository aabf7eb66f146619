"""Leaves in Python: what a class says of itself, and what the engine asks of it."""
import asyncio
import sys
import threading
from typing import Optional

import pytest

import coppice
from coppice import (FAILURE, RUNNING, SUCCESS, Action, AsyncAction, Condition, InOut, Input, Output,
                     Registry, SyncAction)
from coppice.testing import LeafHarness


class IsDark(Condition):
    """Is it too dark for the camera?"""
    lux: Input[float] = Input("brightness", unit="lx")
    limit: Input[float] = Input("dark below this", unit="lx", default=10.0)

    def check(self) -> bool:
        return self.lux < self.limit


def test_a_condition_is_success_when_it_is_true():
    leaf = LeafHarness(IsDark)
    leaf["lux"] = 9.0
    assert leaf.tick() == SUCCESS


def test_a_condition_is_failure_when_it_is_false():
    leaf = LeafHarness(IsDark)
    leaf["lux"] = 10
    assert leaf.tick() == FAILURE


def test_the_manifest_has_description_unit_and_default():
    models = Registry([IsDark]).models()
    assert 'Condition ID="IsDark"' in models and "Is it too dark for the camera?" in models
    assert 'name="limit" type="double" default="10">dark below this [lx]' in models


def test_the_models_are_what_the_checker_takes(tmp_path):
    Registry([IsDark]).write_models(tmp_path / "models.xml")
    text = (tmp_path / "models.xml").read_text()
    problems = coppice.checks(text, file="models.xml")
    assert not [p for p in problems if p.is_error]


def test_a_port_that_is_annotated_only_is_a_port():
    class Bare(Condition):
        lux: Input[float]
        dark: Input[bool] = False

        def check(self) -> bool:
            return self.dark or self.lux < 1
    leaf = LeafHarness(Bare)
    leaf["lux"] = 0.5
    assert leaf.tick() == SUCCESS


def test_an_optional_input_without_value_is_none():
    class Maybe(Condition):
        lux: Input[Optional[float]]

        def check(self) -> bool:
            return self.lux is None
    assert LeafHarness(Maybe).tick() == SUCCESS


def test_an_input_without_value_fails_the_leaf_and_names_the_key():
    leaf = LeafHarness(IsDark)
    assert leaf.tick() == FAILURE
    assert 'nobody has written key "lux" yet' in leaf.message


def test_outputs_are_written():
    class Half(SyncAction):
        whole: Input[float]
        half: Output[float]

        def run(self):
            self.half = self.whole / 2
            return SUCCESS
    leaf = LeafHarness(Half)
    leaf["whole"] = 3
    leaf.tick()
    assert leaf["half"] == 1.5


def test_an_inout_port_is_read_and_written():
    class Count(SyncAction):
        n: InOut[int]

        def run(self):
            self.n += 1
            return SUCCESS
    leaf = LeafHarness(Count)
    leaf["n"] = 4
    leaf.tick()
    assert leaf["n"] == 5


def test_an_exception_is_failure_with_its_traceback():
    class Breaks(SyncAction):
        def run(self):
            return {}["nothing"]
    leaf = LeafHarness(Breaks)
    assert leaf.tick() == FAILURE
    assert 'return {}["nothing"]' in leaf.message
    assert leaf.message.endswith("KeyError: 'nothing'")


def test_the_traceback_has_no_frames_of_the_package():
    leaf = LeafHarness(IsDark)
    leaf.tick()
    assert leaf.message.count("File ") == 1


@pytest.mark.parametrize("result", [None, True, "SUCCESS", 2])
def test_an_action_that_returns_no_status_fails_and_says_so(result):
    class Odd(SyncAction):
        def run(self):
            return result
    leaf = LeafHarness(Odd)
    assert leaf.tick() == FAILURE
    assert f"returned {result!r}; expected a coppice.Status" in leaf.message


def test_a_condition_that_returns_nothing_is_told_of_the_missing_return():
    class Odd(Condition):
        def check(self):
            pass
    leaf = LeafHarness(Odd)
    leaf.tick()
    assert "expected True or False (is there a return on every way?)" in leaf.message


def test_a_leaf_that_returns_idle_fails():
    class Idle(SyncAction):
        def run(self):
            return coppice.IDLE
    leaf = LeafHarness(Idle)
    assert leaf.tick() == FAILURE
    assert "returned IDLE" in leaf.message


class Drive(Action):
    """Takes two ticks."""
    log: list = []

    def __init__(self, name="robot"):
        self.name = name

    def on_start(self):
        self.log.append(f"{self.name} starts")
        self.wake_after(2)
        return RUNNING

    def on_running(self):
        self.log.append("goes on")
        return SUCCESS

    def on_halted(self):
        self.log.append("is halted")


def test_an_action_starts_and_goes_on():
    Drive.log.clear()
    leaf = LeafHarness(Drive, "Sobi")
    assert leaf.tick() == RUNNING
    assert leaf.next_tick == 2
    leaf.advance(2)
    assert leaf.tick() == SUCCESS
    assert Drive.log == ["Sobi starts", "goes on"]


def test_a_running_action_is_halted():
    Drive.log.clear()
    leaf = LeafHarness(Drive)
    leaf.tick()
    leaf.halt()
    assert Drive.log == ["robot starts", "is halted"]


def test_an_answer_of_another_thread_wakes_the_leaf():
    class Ask(Action):
        def on_start(self):
            threading.Thread(target=self.new_sender(), args=({"answer": 42},)).start()
            return RUNNING

        def on_running(self):
            answer = self.take()
            if answer is None:
                return RUNNING
            return SUCCESS if answer["answer"] == 42 else FAILURE
    assert LeafHarness(Ask).tick_until_done() == SUCCESS


def test_an_answer_to_an_earlier_activation_is_dropped():
    senders = []

    class Ask(Action):
        def on_start(self):
            senders.append(self.new_sender())
            return RUNNING

        def on_running(self):
            return RUNNING if self.take() is None else SUCCESS
    leaf = LeafHarness(Ask)
    leaf.tick()
    leaf.halt()
    leaf.tick()
    senders[0]("late")
    assert leaf.tick() == RUNNING
    senders[1]("now")
    assert leaf.tick() == SUCCESS


def test_ports_are_not_for_other_threads():
    caught = []

    class Leaky(Action):
        lux: Input[float] = 1.0

        def on_start(self):
            def read():
                try:
                    self.lux
                except RuntimeError as error:
                    caught.append(str(error))
            thread = threading.Thread(target=read)
            thread.start()
            thread.join()
            return SUCCESS

        def on_running(self):
            return SUCCESS
    assert LeafHarness(Leaky).tick() == SUCCESS
    assert "on that thread only" in caught[0]


def test_a_leaf_outlives_its_tree_and_says_so():
    kept = []

    class Kept(SyncAction):
        lux: Input[float] = 1.0

        def run(self):
            kept.append(self)
            return SUCCESS
    leaf = LeafHarness(Kept)
    leaf.tick()
    del leaf
    with pytest.raises(RuntimeError, match="the tree of this leaf is gone"):
        kept[0].lux


class Wait(AsyncAction):
    seconds: Input[float] = 0.001
    said: Output[str]
    ended: list = []

    async def run(self):
        self.said = "begun"
        try:
            await asyncio.sleep(self.seconds)
        finally:
            self.ended.append(True)
        self.said = "done"
        return SUCCESS


def test_a_coroutine_runs_beside_the_tree():
    leaf = LeafHarness(Wait)
    assert leaf.tick() == RUNNING
    assert leaf.tick_until_done() == SUCCESS
    assert leaf["said"] == "done"


def test_a_halted_coroutine_is_cancelled():
    Wait.ended.clear()
    leaf = LeafHarness(Wait)
    leaf["seconds"] = 1000.0
    leaf.tick()
    while "said" not in leaf:  # it has begun
        leaf.tick_until_done(0.001)
    leaf.halt()
    assert leaf.wait_until_stopped()
    assert Wait.ended == [True]


def test_a_coroutine_that_raises_fails_with_its_traceback():
    class Breaks(AsyncAction):
        async def run(self):
            await asyncio.sleep(0)
            raise ValueError("no such place")
    leaf = LeafHarness(Breaks)
    assert leaf.tick_until_done() == FAILURE
    assert "await" not in leaf.message and leaf.message.endswith("ValueError: no such place")


def test_a_coroutine_that_ends_the_program_ends_its_tree_and_no_other_coroutine():
    class Ends(AsyncAction):
        async def run(self):
            raise SystemExit(3)

    with pytest.raises(SystemExit):
        LeafHarness(Ends).tick_until_done()
    assert LeafHarness(Wait).tick_until_done() == SUCCESS


def test_a_coroutine_that_stops_the_loop_keeps_no_other_one_waiting():
    class Stops(AsyncAction):
        async def run(self):
            asyncio.get_running_loop().stop()
            asyncio.get_running_loop().call_soon(sys.exit)
            await asyncio.sleep(0)
            return SUCCESS

    assert LeafHarness(Stops).tick_until_done() == SUCCESS
    assert LeafHarness(Wait).tick_until_done() == SUCCESS


def test_a_run_that_is_no_coroutine_fails_and_says_so():
    class Plain(AsyncAction):
        def run(self):
            return SUCCESS

    leaf = LeafHarness(Plain)
    assert leaf.tick() == FAILURE
    assert "expected async def run" in leaf.message


def test_a_misspelt_output_is_no_attribute():
    class Near(SyncAction):
        distance: Output[float]

        def run(self):
            self.distnace = 1.0
            return SUCCESS
    leaf = LeafHarness(Near)
    assert leaf.tick() == FAILURE
    assert 'did you mean "distance"?' in leaf.message


def test_a_misspelt_input_is_told_with_the_right_name():
    class Near(Condition):
        lux: Input[float] = 1.0

        def check(self):
            return self.lxu > 0
    leaf = LeafHarness(Near)
    leaf.tick()
    assert 'neither port nor attribute "lxu" (did you mean "lux"?)' in leaf.message


def test_an_input_cannot_be_written():
    class Writes(SyncAction):
        lux: Input[float] = 1.0

        def run(self):
            self.lux = 2.0
            return SUCCESS
    leaf = LeafHarness(Writes)
    leaf.tick()
    assert "Writes.lux is an input" in leaf.message


def test_a_value_of_another_type_is_refused_with_the_name_of_the_port():
    class Writes(SyncAction):
        n: Output[int]

        def run(self):
            self.n = 1.5
            return SUCCESS
    leaf = LeafHarness(Writes)
    leaf.tick()
    assert 'TypeError: port "n": expected int, not float 1.5' in leaf.message


def test_a_port_without_annotation_is_an_error_of_the_class():
    with pytest.raises(TypeError, match=r"Odd.lux: say what it holds"):
        class Odd(Condition):
            lux = Input("brightness")


def test_a_port_of_an_impossible_type_is_an_error_of_the_class():
    with pytest.raises(TypeError, match="Odd.lux: a port cannot be of type"):
        class Odd(Condition):
            lux: Input[dict[str, int]]


def test_a_default_of_another_type_is_refused_with_the_name_of_the_port():
    class Odd(Condition):
        lux: Input[float] = Input("brightness", default="dark")
    with pytest.raises(TypeError, match='default of port "lux": expected float, not str'):
        Registry([Odd])


def test_an_object_is_no_default():
    with pytest.raises(TypeError, match="Odd.place: an object cannot be written in XML"):
        class Odd(Condition):
            place: Input[dict] = Input(default={})


def test_a_name_that_is_taken_is_refused():
    registry = Registry([IsDark])
    with pytest.raises(ValueError, match='"IsDark" is already registered'):
        registry.register(IsDark)


def test_what_is_no_class_of_leaves_is_refused():
    with pytest.raises(TypeError, match="is no class of leaves"):
        Registry().register(print)


def test_functions_are_leaves_with_their_parameters_as_ports():
    registry = Registry()

    @registry.condition
    def is_warm(celsius: float, limit: float = 20.0) -> bool:
        """Is it warm?"""
        return celsius > limit

    @registry.action(id="Shout")
    def shout(text: str):
        assert text == "hello"
        return SUCCESS
    tree = coppice.loads("""<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence>
        <is_warm celsius="{t}"/><Shout text="hello"/></Sequence></BehaviorTree></root>""", registry)
    tree["t"] = 25
    assert tree.tick() == SUCCESS


def test_the_leaf_of_a_base_class_has_its_ports():
    class IsVeryDark(IsDark):
        factor: Input[float] = 0.5

        def check(self) -> bool:
            return self.lux < self.limit * self.factor
    leaf = LeafHarness(IsVeryDark)
    leaf["lux"] = 6.0
    assert leaf.tick() == FAILURE


@pytest.mark.parametrize("count", [1, 6])
def test_a_class_that_has_methods_of_its_own_for_those_of_its_base_is_refused(count):
    class Own(Condition):
        """It has no check."""
        _methods = ("check",) * count

        def check(self) -> bool:
            return True
    with pytest.raises(TypeError, match=f"4 methods, not {count}"):
        LeafHarness(Own).tick()


@pytest.mark.parametrize("methods", [("",) * 4, ("check", "", "", ""), ("", "check", "", "")])
def test_a_class_without_a_method_to_tick_it_by_is_refused(methods):
    class Silent(Condition):
        """It would be true whatever check() says."""
        _methods = methods

        def check(self) -> bool:
            return False
    with pytest.raises(TypeError, match="Silent has no method that is called when it is ticked"):
        Registry([Silent])
