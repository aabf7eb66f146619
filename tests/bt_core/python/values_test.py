"""What ports and keys hold, in Python."""
import datetime
import math

import pytest

import coppice
from coppice import SUCCESS, InOut, Input, Int64, Output, Status, SyncAction
from coppice.testing import LeafHarness


def through(annotation, value):
    """Writes a value to an input, passes it through a leaf, reads the output."""
    class Pass(SyncAction):
        __annotations__ = {"into": Input[annotation], "out": Output[annotation]}

        def run(self):
            self.out = self.into
            return SUCCESS
    leaf = LeafHarness(Pass)
    leaf["into"] = value
    assert leaf.tick() == SUCCESS, leaf.message
    return leaf["out"]


@pytest.mark.parametrize("annotation,value", [
    (bool, True), (int, -7), (Int64, 2 ** 62), (float, 0.1), (float, math.inf), (str, "Grüße"),
    (list[int], [1, 2]), (list[float], [0.5]), (list[bool], [True, False]), (list[str], ["a", ""]),
    (datetime.timedelta, datetime.timedelta(seconds=1.5)), (Status, Status.SKIPPED),
    (object, None), (dict, {"a": [1]}),
])
def test_a_value_comes_through_as_it_is(annotation, value):
    assert through(annotation, value) == value


def test_an_object_comes_through_itself():
    thing = object()
    assert through(object, thing) is thing


def test_a_whole_number_is_a_float_too():
    assert through(float, 3) == 3.0


@pytest.mark.parametrize("annotation,value,told", [
    (float, "3", "expected float, not str '3'"), (float, True, "expected float, not bool True"),
    (int, 1.0, "expected int, not float 1.0"), (bool, 1, "expected bool, not int 1"),
    (str, b"a", "expected str, not bytes b'a'"), (list[float], "ab", "expected list of double"),
    (datetime.timedelta, 5, "expected datetime.timedelta, not int 5"),
    (dict, [1], r"expected dict, not list \[1\]"),
])
def test_a_value_of_another_type_is_refused(annotation, value, told):
    with pytest.raises(TypeError, match=told):
        through(annotation, value)


def test_a_time_of_centuries_is_refused():
    for value in (datetime.timedelta.max, datetime.timedelta.min):
        with pytest.raises(ValueError, match="is more than a duration can be"):
            through(datetime.timedelta, value)


def test_a_number_that_does_not_fit_is_refused():
    with pytest.raises(ValueError, match="2147483648 does not fit into int"):
        through(int, 2 ** 31)


def test_a_status_may_be_named():
    assert through(Status, "SUCCESS") == Status.SUCCESS


def test_a_wrong_name_of_a_status_is_refused_with_the_right_ones():
    with pytest.raises(ValueError, match="IDLE, RUNNING, SUCCESS, FAILURE or SKIPPED"):
        through(Status, "OK")


class Pose:
    pass


class Place:
    pass


class GivesPose(SyncAction):
    pose: Output[Pose]

    def run(self):
        self.pose = Pose()
        return SUCCESS


class TakesPlace(SyncAction):
    place: Input[Place]

    def run(self):
        return SUCCESS


def test_ports_of_two_classes_do_not_share_a_key():
    with pytest.raises(coppice.LoadError) as error:
        coppice.loads("""<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence>
            <GivesPose pose="{p}"/><TakesPlace place="{p}"/></Sequence></BehaviorTree></root>""",
                      [GivesPose, TakesPlace])
    assert "Pose" in str(error.value) and "Place" in str(error.value)


def test_scripts_and_leaves_share_numbers():
    class Twice(SyncAction):
        n: InOut[int]

        def run(self):
            self.n *= 2
            return SUCCESS
    tree = coppice.loads("""<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence>
        <Script code="n := 3"/><Twice n="{n}"/><ScriptCondition code="n == 6"/>
        </Sequence></BehaviorTree></root>""", [Twice])
    assert tree.tick() == SUCCESS
