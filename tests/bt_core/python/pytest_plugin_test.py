"""Scenarios that pytest collects by itself."""
import os
import subprocess
import sys

import pytest

TREE = ('<root BTCPP_format="4"><BehaviorTree ID="Main"><Knock door="{door}"/></BehaviorTree>'
        "</root>")
LEAVES = """
from coppice import FAILURE, SUCCESS, Input, SyncAction

class Knock(SyncAction):
    door: Input[str]

    def run(self):
        return SUCCESS if self.door == "front" else FAILURE

ALL = [Knock]
"""
KNOCKS = ('{"tree": "t.xml", "scenarios": [{"name": "knocks", "steps": [\n'
          '{"set": {"door": "%s"}, "expect": {"status": "SUCCESS"}}]}]}')


@pytest.fixture
def project(tmp_path):
    (tmp_path / "pytest.ini").write_text("[pytest]\ncoppice_leaves = leaves:ALL\n")
    (tmp_path / "leaves.py").write_text(LEAVES)
    (tmp_path / "t.xml").write_text(TREE)
    return tmp_path


def run_pytest(folder, *options):
    path = os.pathsep.join([os.environ["PYTHONPATH"], str(folder)])
    done = subprocess.run(
        [sys.executable, "-B", "-m", "pytest", "-q", "-p", "no:cacheprovider", *options],
        cwd=folder, env={**os.environ, "PYTHONPATH": path}, capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def test_a_scenario_is_a_test(project):
    (project / "t.test.json").write_text(KNOCKS % "front")
    code, told = run_pytest(project, "-vv")
    assert code == 0, told
    assert "t.test.json::knocks PASSED" in told


def test_a_module_stands_for_its_leaves(project):
    (project / "pytest.ini").write_text("[pytest]\ncoppice_leaves = leaves\n")
    (project / "t.test.json").write_text(KNOCKS % "front")
    code, told = run_pytest(project)
    assert code == 0, told


def test_one_that_differs_fails_with_its_place(project):
    (project / "t.test.json").write_text(KNOCKS % "back")
    code, told = run_pytest(project)
    assert code == 1, told
    assert "t.test.json:2:" in told and "expected SUCCESS" in told
    assert "pytest_plugin.py" not in told


def test_a_tree_that_cannot_be_loaded_is_an_error(project):
    (project / "t.xml").write_text(TREE.replace("</root>", ""))
    (project / "t.test.json").write_text(KNOCKS % "front")
    code, told = run_pytest(project)
    assert code == 2, told
    assert "t.xml:1:" in told


def test_other_files_of_that_name_are_left_alone(project):
    (project / "other.test.json").write_text('{"rows": []}')
    code, told = run_pytest(project)
    assert code == 5, told  # no tests


def test_leaves_that_are_not_there_are_told(project):
    (project / "pytest.ini").write_text("[pytest]\ncoppice_leaves = leaves:NONE\n")
    (project / "t.test.json").write_text(KNOCKS % "front")
    code, told = run_pytest(project)
    assert code != 0
    assert "coppice_leaves = leaves:NONE" in told
