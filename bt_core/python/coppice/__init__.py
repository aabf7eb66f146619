"""Coppice: behaviour trees for robots that must recover by themselves.

    import coppice
    from coppice import Condition, Input

    class IsDark(Condition):
        \"\"\"Is it too dark for the camera?\"\"\"
        lux: Input[float] = Input("brightness", unit="lx")

        def check(self) -> bool:
            return self.lux < 10

    tree = coppice.load("patrol.xml", [IsDark])
    tree["lux"] = 3.0
    tree.run()

docs/python.md is the manual.
"""
import atexit as _atexit

from . import _native
from ._native import (Clock, Diagnostic, SimulatedClock, Status, UnsetInput, WallClock,
                      __version__)
from .control import Child, Children, Control, Decorator
from .coroutine import LOOP as _LOOP
from .coroutine import AsyncAction, use_event_loop
from .leaf import Action, Condition, Leaf, SyncAction
from .ports import InOut, Input, Int64, Output
from .records import Record, open_record
from .registry import Registry
from .tree import Live, LoadError, Node, Recorder, Tree, check, checks
from .tree import close_watchers as _close_watchers
from .tree import load, loads

RUNNING = Status.RUNNING
SUCCESS = Status.SUCCESS
FAILURE = Status.FAILURE
SKIPPED = Status.SKIPPED
IDLE = Status.IDLE

__all__ = [
    "Action", "AsyncAction", "Child", "Children", "Clock", "Condition", "Control", "Decorator",
    "Diagnostic", "FAILURE", "IDLE", "InOut", "Input", "Int64", "Leaf", "Live", "LoadError", "Node",
    "Output", "RUNNING", "Record", "Recorder", "Registry", "SKIPPED", "SUCCESS", "SimulatedClock",
    "Status", "SyncAction", "Tree", "UnsetInput", "WallClock", "check", "checks", "load", "loads",
    "open_record", "use_event_loop",
]

for _type in (Clock, Diagnostic, LoadError, SimulatedClock, Status, UnsetInput, WallClock):
    _type.__module__ = __name__  # as people know them, in messages


@_atexit.register
def _end() -> None:
    _native.end_all_trees()
    _close_watchers()
    _LOOP.end()
