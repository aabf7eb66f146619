"""Scenarios of whole trees, from pytest."""
import os
import pathlib

import pytest

import coppice
from coppice import FAILURE, SUCCESS, Input, SyncAction
from coppice.testing import scenarios

TREES = pathlib.Path(os.environ["COPPICE_SOURCE"], "trees")


@pytest.mark.parametrize("scenario", scenarios(TREES / "behavior/drive_to.test.json"), ids=str)
def test_a_shipped_tree_does_what_its_scenarios_say(scenario):
    scenario.check()


class Knock(SyncAction):
    door: Input[str]

    def run(self):
        return SUCCESS if self.door == "front" else FAILURE


def suite(tmp_path, expected):
    (tmp_path / "t.xml").write_text('<root BTCPP_format="4"><BehaviorTree ID="Main">'
                                    '<Knock door="{door}"/></BehaviorTree></root>')
    (tmp_path / "t.test.json").write_text(
        '{"tree": "t.xml", "scenarios": [{"name": "knocks", "steps": [\n'
        '{"set": {"door": "front"}, "expect": {"status": "%s"}}]}]}' % expected)
    return tmp_path / "t.test.json"


def test_a_leaf_in_python_runs_as_it_is(tmp_path):
    scenarios(suite(tmp_path, "SUCCESS"), [Knock])[0].check()


def test_what_differs_is_told_with_its_place(tmp_path):
    with pytest.raises(AssertionError) as error:
        scenarios(suite(tmp_path, "FAILURE"), [Knock])[0].check()
    assert "t.test.json:2:" in str(error.value) and "got      SUCCESS" in str(error.value)


def test_a_file_that_is_wrong_is_told(tmp_path):
    (tmp_path / "w.test.json").write_text('{"tree": "t.xml", "scenarois": []}')
    with pytest.raises(coppice.LoadError, match="scenarois"):
        scenarios(tmp_path / "w.test.json")
