"""Base classes of control nodes and decorators.

    class Alternate(Control):
        \"\"\"Ticks one child per activation, in turn.\"\"\"
        current = -1

        def tick(self, starting: bool) -> Status:
            if starting:
                self.current = (self.current + 1) % len(self.children)
            return self.children[self.current].tick()

    class Invert(Decorator):
        \"\"\"SUCCESS becomes FAILURE and the reverse.\"\"\"

        def tick(self, starting: bool) -> Status:
            status = self.child.tick()
            return {SUCCESS: FAILURE, FAILURE: SUCCESS}.get(status, status)

Ports and messages are those of leaves. The engine keeps the children in order: when tick() returns
anything but RUNNING, or raises, all of them are made idle and those that run are halted; when the
node is halted they are, right after on_halted().
"""
from __future__ import annotations

from typing import Iterator

from ._native import NodeLink, Status
from .leaf import Leaf


class Child:
    """A child of a node; to be used in its tick()."""

    def __init__(self, node: NodeLink, number: int) -> None:
        self._node = node
        self.number = number

    def tick(self) -> Status:
        """Ticks it: starts it, unless it is RUNNING. A child that raises returns FAILURE."""
        return self._node.tick_child(self.number)

    @property
    def status(self) -> Status:
        """IDLE, RUNNING, or what it returned last in this activation of the parent."""
        return self._node.status_of_child(self.number)

    def halt(self) -> None:
        """Halts it if it is RUNNING, and makes it IDLE."""
        self._node.halt_child(self.number)


class Children:
    """The children of a node, in the order of the document."""

    def __init__(self, node: NodeLink) -> None:
        self._node = node

    def __len__(self) -> int:
        return self._node.count_children()

    def __getitem__(self, number: int) -> Child:
        count = len(self)
        if not -count <= number < count:
            raise IndexError(f"there is no child {number} of {count}; the first one is 0")
        return Child(self._node, number % count)

    def __iter__(self) -> Iterator[Child]:
        return (Child(self._node, number) for number in range(len(self)))


class Control(Leaf):
    """A node with one child or more."""
    _category = "control"
    _methods = ("_start", "_go_on", "on_halted", "")

    def tick(self, starting: bool) -> Status:
        """One tick: decides which children are ticked, and the result. `starting` in the first one
        of an activation."""
        raise NotImplementedError(f"{type(self).__name__} has no tick()")

    def on_halted(self) -> None:
        """It was RUNNING and is no longer wanted. Its children are halted right after."""

    @property
    def children(self) -> Children:
        """Its children; to be used in tick()."""
        return Children(self._node)

    def _start(self) -> Status:
        return self.tick(True)

    def _go_on(self) -> Status:
        return self.tick(False)


class Decorator(Control):
    """A node with exactly one child."""
    _category = "decorator"

    @property
    def child(self) -> Child:
        """Its child; to be used in tick()."""
        return Child(self._node, 0)
