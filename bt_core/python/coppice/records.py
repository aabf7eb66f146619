"""Recorded runs as iterables and as tables of pandas.

    record = coppice.open_record("run.coppice")
    for tick in record:
        print(tick.number, tick.time, tick.result)
    record.changes_frame().groupby("node").size()
    print(record.why("drive", tick=42))
"""
from __future__ import annotations

import json
import os
from typing import Any, Dict, Iterator, List, NamedTuple, Optional, Tuple, Union

from . import _native
from ._native import Diagnostic, Status


class Change(NamedTuple):
    """A change of a node's status."""
    node: str
    before: Status
    after: Status


class Write(NamedTuple):
    """A key that was written: by a node, or from outside (then `writer` is empty)."""
    key: str
    value: Any
    writer: str


class Message(NamedTuple):
    """What a node said: why it failed, the traceback of its exception."""
    node: str
    text: str


class Tick(NamedTuple):
    """A tick, or what happened between two ticks (`result` is IDLE then)."""
    number: int
    time: float
    """Since the start of the record, in the tree's clock [s]."""
    duration: float
    """In real time [s]."""
    result: Status
    changes: List[Change]
    writes: List[Write]
    messages: List[Message]


class Record:
    """A recorded run in memory; see the module."""

    def __init__(self, native: _native.Record, warnings: List[Diagnostic]) -> None:
        self._native = native
        self.warnings = warnings

    def __len__(self) -> int:
        return len(self._native)

    def __iter__(self) -> Iterator[Tick]:
        for number, time, duration, result, changes, writes, messages in self._native.ticks():
            yield Tick(number, time, duration, result, [Change(*c) for c in changes],
                       [Write(*w) for w in writes], [Message(*m) for m in messages])

    @property
    def main_tree(self) -> str:
        """ID of the tree that ran."""
        return self._native.main_tree()

    @property
    def metadata(self) -> Dict[str, str]:
        """What the program wanted to be known of the run."""
        return self._native.metadata()

    @property
    def nodes(self) -> List[Tuple[str, str]]:
        """Path and type of each node."""
        return self._native.nodes()

    @property
    def wall_start(self) -> float:
        """When it began [s since 1970]."""
        return self._native.wall_start()

    @property
    def is_closed(self) -> bool:
        """Whether the recording was closed in order."""
        return self._native.is_closed()

    def why(self, node: str, tick: Optional[int] = None) -> str:
        """Why the node has the status that it has after a tick (None: the last one), or why it was
        not ticked. Raises KeyError with advice."""
        return self._native.why(node, tick)

    def statistics(self) -> Dict[str, Any]:
        """Figures of the run and of each node, as `coppice stats --json` gives them."""
        figures: Dict[str, Any] = json.loads(self._native.statistics())
        return figures

    def ticks_frame(self) -> Any:
        """A pandas.DataFrame: tick, time, duration, result."""
        return _frame([(t.number, t.time, t.duration, t.result.name) for t in self],
                      ["tick", "time", "duration", "result"])

    def changes_frame(self) -> Any:
        """A pandas.DataFrame: tick, time, node, before, after."""
        return _frame([(t.number, t.time, c.node, c.before.name, c.after.name)
                       for t in self for c in t.changes],
                      ["tick", "time", "node", "before", "after"])

    def writes_frame(self) -> Any:
        """A pandas.DataFrame: tick, time, key, value, writer."""
        return _frame([(t.number, t.time, w.key, w.value, w.writer)
                       for t in self for w in t.writes],
                      ["tick", "time", "key", "value", "writer"])

    def messages_frame(self) -> Any:
        """A pandas.DataFrame: tick, time, node, text."""
        return _frame([(t.number, t.time, m.node, m.text) for t in self for m in t.messages],
                      ["tick", "time", "node", "text"])

    def __repr__(self) -> str:
        return f"<coppice.Record of {self.main_tree}: {len(self)} ticks>"


def _frame(rows: List[tuple], columns: List[str]) -> Any:
    try:
        import pandas  # type: ignore[import]
    except ImportError:
        raise ImportError("tables need pandas: apt-get install python3-pandas") from None
    return pandas.DataFrame(rows, columns=columns)


def open_record(path: Union[str, "os.PathLike[str]"]) -> Record:
    """Reads a record and the files that continue it. Raises ValueError if there is no run in it."""
    record, diagnostics = _native.open_record(os.fspath(path))
    if record is None:
        raise ValueError("\n".join(str(one) for one in diagnostics))
    return Record(record, diagnostics)
