"""Scenarios as tests of pytest: every *.test.json that it finds is collected, each scenario a test.

    # pytest.ini
    [pytest]
    coppice_leaves = my_robot.leaves              # all classes of that module
    coppice_leaves = my_robot.leaves:registry     # or a Registry, or a list of classes

The package python3-coppice tells pytest of it; `-p no:coppice` leaves it out.
"""
from __future__ import annotations

import importlib
import json
import pathlib
from typing import Any, Iterable, Optional, Tuple

import pytest

from .leaf import Leaf
from .registry import Leaves
from .testing import Scenario, scenarios
from .tree import LoadError

_OPTION = "coppice_leaves"


def pytest_addoption(parser: pytest.Parser) -> None:
    """The line of pytest.ini."""
    parser.addini(_OPTION, "leaves of the scenarios: MODULE, or MODULE:NAME of a Registry or list")


def pytest_collect_file(file_path: pathlib.Path,
                        parent: pytest.Collector) -> Optional[ScenarioFile]:
    """Files of scenarios; other *.test.json are none of ours."""
    if not file_path.name.endswith(".test.json") or not _has_scenarios(file_path):
        return None
    return ScenarioFile.from_parent(parent, path=file_path)  # type: ignore[no-any-return]


def _has_scenarios(path: pathlib.Path) -> bool:
    try:
        told = json.loads(path.read_text(encoding="utf-8"))
    except ValueError:
        return True  # it is said when it is collected
    return isinstance(told, dict) and "scenarios" in told


def _leaves(name: str) -> Leaves:
    if not name:
        return ()
    path, _, attribute = name.partition(":")
    try:
        module = importlib.import_module(path)
        if attribute:
            return getattr(module, attribute)  # type: ignore[no-any-return]
    except (ImportError, AttributeError) as error:
        raise pytest.UsageError(f"{_OPTION} = {name}: {error}") from error
    return [one for one in vars(module).values()
            if isinstance(one, type) and issubclass(one, Leaf) and one.__module__ == path]


class ScenarioFile(pytest.File):
    """One *.test.json."""

    def collect(self) -> Iterable[ScenarioItem]:
        """Its scenarios. What is wrong with the tree or the file is an error of the collection."""
        try:
            found = scenarios(self.path, _leaves(self.config.getini(_OPTION)))
        except LoadError as error:
            raise self.CollectError(str(error)) from None
        for scenario in found:
            yield ScenarioItem.from_parent(self, name=scenario.name, scenario=scenario)


class ScenarioItem(pytest.Item):
    """One scenario."""

    def __init__(self, *, scenario: Scenario, **keywords: Any) -> None:
        super().__init__(**keywords)
        self.scenario = scenario

    def runtest(self) -> None:
        """Plays it."""
        self.scenario.check()

    def repr_failure(self, excinfo: Any, style: Any = None) -> Any:
        """What differs, with its place in the file, and no frames of this package."""
        if excinfo.errisinstance(AssertionError):
            return str(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> Tuple[pathlib.Path, Optional[int], str]:
        """Where it is."""
        return self.path, None, self.name
