"""Tests of leaves and of whole trees, on simulated time, without a robot.

    def test_ten_lux_are_dark():
        leaf = LeafHarness(IsDark)
        leaf["lux"] = 9.0
        assert leaf.tick() == SUCCESS

    @pytest.mark.parametrize("scenario", scenarios("patrol.test.json", [IsDark]), ids=str)
    def test_patrol(scenario):
        scenario.check()
"""
from __future__ import annotations

import os
from typing import Any, List, Type, Union

from . import _native
from ._native import Status
from .leaf import Leaf
from .registry import Leaves, Registry, registry_of
from .tree import LoadError


class LeafHarness:
    """Ticks one leaf alone, in the real engine. Each port is bound to a key of its own name; one
    with a default has that value until the test sets another. The arguments go to its __init__."""

    def __init__(self, leaf: Type[Leaf], *arguments: Any, **keywords: Any) -> None:
        registry = Registry()
        registry.register(leaf, *arguments, id="Node", **keywords)
        self._native = _native.Harness(registry._native, "Node")

    def __setitem__(self, port: str, value: Any) -> None:
        """Gives an input its value, as if another node had written the key. Raises ValueError if
        there is no such port, TypeError if it has another type."""
        self._native.set(port, value)

    def __getitem__(self, port: str) -> Any:
        """What an output wrote; raises KeyError if it was not written."""
        if not self._native.was_written(port):
            raise KeyError(f'port "{port}" was not written')
        return self._native.get(port)

    def __contains__(self, port: str) -> bool:
        """Whether the port was written."""
        return self._native.was_written(port)

    def tick(self) -> Status:
        """One tick."""
        return self._native.tick()

    def tick_until_done(self, limit: float = 10.0) -> Status:
        """Ticks until the leaf is done: moves the time to each wake-up that it asks for, and where
        it asks for none waits for an answer of another thread. RUNNING if after `limit` seconds of
        real time it is still not done."""
        return self._native.tick_until_done(limit)

    def halt(self) -> None:
        """Halts the leaf."""
        self._native.halt()

    def wait_until_stopped(self) -> bool:
        """After halt(): waits until the leaf has stopped. False if after 10 s it has not."""
        return self._native.wait_until_stopped()

    def advance(self, seconds: float) -> None:
        """Lets time pass."""
        self._native.advance(seconds)

    @property
    def next_tick(self) -> float:
        """When it asked to be ticked again, in simulated time [s]; inf if it did not."""
        return self._native.next_tick()

    @property
    def messages(self) -> List[str]:
        """What the leaf said in the last tick or halt."""
        return self._native.messages()

    @property
    def message(self) -> str:
        """The last of them, or nothing."""
        return self.messages[-1] if self.messages else ""


class Scenario:
    """One scenario of a file, ready to be played."""

    def __init__(self, suite: _native.Suite, number: int, name: str) -> None:
        self._suite = suite
        self._number = number
        self.name = name

    def differences(self) -> List[str]:
        """Plays it; says where the tree did something else than was expected."""
        return [f"{file}:{line}:{column}: " + (f"step {step}: " if step else "")
                + f"{what}\n    expected {expected}\n    got      {got}"
                for file, line, column, step, what, expected, got
                in self._suite.run(self._number)]

    def check(self) -> None:
        """Plays it; raises AssertionError with the differences."""
        differences = self.differences()
        if differences:
            raise AssertionError(f"{self.name}\n  " + "\n  ".join(differences))

    def __str__(self) -> str:
        return self.name

    def __repr__(self) -> str:
        return f"<coppice.testing.Scenario {self.name!r}>"


def scenarios(path: Union[str, "os.PathLike[str]"], leaves: Leaves = ()) -> List[Scenario]:
    """Those of a file (docs/testing.md). `leaves` run as they are, unless a script plays them; other
    leaves need one. Raises LoadError."""
    suite, diagnostics = _native.load_suite(os.fspath(path), registry_of(leaves))
    if suite is None:
        raise LoadError(diagnostics)
    return [Scenario(suite, number, name) for number, name in enumerate(suite.names())]
