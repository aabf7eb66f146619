"""Control nodes and decorators in Python."""
import enum

import pytest

import coppice
from coppice import (FAILURE, IDLE, RUNNING, SUCCESS, Action, Control, Decorator, Input, Output,
                     SyncAction)


def tree_of(body, classes, **options):
    return coppice.loads('<root BTCPP_format="4"><BehaviorTree ID="Main">' + body
                         + "</BehaviorTree></root>", classes, **options)


class Alternate(Control):
    """Ticks one child per activation, in turn."""
    current = -1

    def tick(self, starting):
        if starting:
            self.current = (self.current + 1) % len(self.children)
        return self.children[self.current].tick()


class Invert(Decorator):
    """SUCCESS becomes FAILURE and the reverse."""

    def tick(self, starting):
        return {SUCCESS: FAILURE, FAILURE: SUCCESS}.get(status := self.child.tick(), status)


class Slow(Action):
    """Runs until it is halted."""
    halts = []

    def on_start(self):
        return RUNNING

    def on_running(self):
        return RUNNING

    def on_halted(self):
        Slow.halts.append(self.path)


class Broken(SyncAction):
    def run(self):
        raise ValueError("broken")


@pytest.fixture(autouse=True)
def no_halts():
    Slow.halts.clear()


def test_a_control_node_ticks_the_children_that_it_chooses():
    tree = tree_of("<Alternate><AlwaysSuccess/><AlwaysFailure/></Alternate>", [Alternate])
    assert [tree.tick() for _ in range(3)] == [SUCCESS, FAILURE, SUCCESS]


def test_a_decorator_has_one_child():
    assert tree_of("<Invert><AlwaysFailure/></Invert>", [Invert]).tick() == SUCCESS
    with pytest.raises(coppice.LoadError, match="child"):
        tree_of("<Invert><AlwaysFailure/><AlwaysFailure/></Invert>", [Invert])


def test_it_may_have_built_in_nodes_above_and_below():
    tree = tree_of("<Sequence><Invert><Fallback><Invert><AlwaysSuccess/></Invert></Fallback>"
                   "</Invert></Sequence>", [Invert])
    assert tree.tick() == SUCCESS


def test_it_is_told_whether_it_begins():
    told = []

    class Tell(Decorator):
        def tick(self, starting):
            told.append(starting)
            return self.child.tick()

    tree = tree_of("<Tell><Slow/></Tell>", [Tell, Slow])
    tree.tick()
    tree.tick()
    assert told == [True, False]
    tree.halt()


def test_its_halt_halts_the_children_behind_its_own():
    class Tell(Decorator):
        def tick(self, starting):
            return self.child.tick()

        def on_halted(self):
            Slow.halts.append("decorator")

    tree = tree_of('<Tell><Slow name="slow"/></Tell>', [Tell, Slow])
    tree.tick()
    tree.halt()
    assert Slow.halts == ["decorator", "slow"]


def test_children_that_run_are_halted_when_it_ends():
    class First(Control):
        def tick(self, starting):
            for child in self.children:
                child.tick()
            assert self.children[0].status == RUNNING
            return SUCCESS

    tree = tree_of('<First><Slow name="a"/><Slow name="b"/></First>', [First, Slow])
    assert tree.tick() == SUCCESS
    assert Slow.halts == ["a", "b"]


def test_it_may_halt_a_child():
    class Stop(Control):
        def tick(self, starting):
            self.children[0].tick()
            self.children[0].halt()
            assert self.children[0].status == IDLE
            return RUNNING

    tree = tree_of('<Stop><Slow name="a"/></Stop>', [Stop, Slow])
    tree.tick()
    assert Slow.halts == ["a"]
    tree.halt()


def test_it_has_ports_and_messages():
    class Times(Decorator):
        times: Input[int]
        done: Output[int]

        def tick(self, starting):
            for number in range(self.times):
                self.child.tick()
                self.done = number + 1
            return SUCCESS

    tree = tree_of('<Times times="3" done="{done}"><AlwaysSuccess/></Times>', [Times])
    assert tree.tick() == SUCCESS
    assert tree["done"] == 3


def test_a_child_that_raises_fails():
    assert tree_of("<Invert><Broken/></Invert>", [Invert, Broken]).tick() == SUCCESS


def test_what_is_to_leave_the_tick_goes_through_it():
    class Ignore(Decorator):
        def tick(self, starting):
            try:
                return self.child.tick()
            except Exception:
                return SUCCESS

    for kind in (Invert, Ignore):
        tree = tree_of(f"<{kind.__name__}><Broken/></{kind.__name__}>", [kind, Broken],
                       on_exception="raise")
        with pytest.raises(ValueError, match="broken"):
            tree.tick()


def test_one_that_raises_fails_and_its_children_are_halted():
    class Fall(Decorator):
        def tick(self, starting):
            self.child.tick()
            raise ValueError("fell")

    tree = tree_of('<Fall><Slow name="a"/></Fall>', [Fall, Slow])
    assert tree.tick() == FAILURE
    assert Slow.halts == ["a"]


def test_a_child_that_is_not_there_is_an_error_with_its_number():
    told = []

    class Wrong(Control):
        def tick(self, starting):
            with pytest.raises(IndexError) as error:
                self.children[2].tick()
            told.append(str(error.value))
            return self.children[-1].tick()

    assert tree_of("<Wrong><AlwaysFailure/><AlwaysSuccess/></Wrong>", [Wrong]).tick() == SUCCESS
    assert told == ["there is no child 2 of 2; the first one is 0"]


def test_models_say_what_it_is():
    registry = coppice.Registry([Alternate, Invert])
    assert '<Control ID="Alternate"' in registry.models()
    assert '<Decorator ID="Invert"' in registry.models()


def test_scripts_know_the_names_of_an_enum():
    registry = coppice.Registry()

    @registry.enum
    class Colour(enum.IntEnum):
        RED = 1
        BLUE = 2

    tree = tree_of('<Script code="colour := BLUE"/>', registry)
    tree.tick()
    assert Colour(tree["colour"]) is Colour.BLUE


def test_a_name_stands_for_one_number():
    registry = coppice.Registry()
    registry.enum(enum.IntEnum("A", {"RED": 1}))
    registry.enum(enum.IntEnum("Same", {"RED": 1}))
    with pytest.raises(ValueError, match="RED"):
        registry.enum(enum.IntEnum("B", {"RED": 2}))
    with pytest.raises(TypeError, match="whole numbers"):
        registry.enum(enum.Enum("C", {"GREEN": "green"}))
