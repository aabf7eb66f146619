"""Trees: load, check, tick, run, watch."""
from __future__ import annotations

import os
import weakref
from types import TracebackType
from typing import Any, Iterator, List, Mapping, NamedTuple, Optional, Sequence, Type, TypeVar, Union

from . import _native
from ._native import Clock, Diagnostic, Status, WallClock
from .leaf import nearest
from .picture import svg_of
from .registry import Leaves, registry_of

Path = Union[str, "os.PathLike[str]"]
W = TypeVar("W", bound="_Watcher")
_TREES: "weakref.WeakSet[Tree]" = weakref.WeakSet()


class LoadError(ValueError):
    """A tree cannot be loaded. Its text has a line for each problem: place, what, hint."""

    def __init__(self, diagnostics: Sequence[Diagnostic]) -> None:
        self.diagnostics = list(diagnostics)
        super().__init__("the tree cannot be loaded:\n" + "\n".join(str(one) for one in diagnostics))


class Node(NamedTuple):
    """A node of a tree, as it is between two ticks."""
    path: str
    id: str
    name: str
    status: Status
    file: str
    line: int
    column: int


class Tree:
    """A tree that is ready to run. `load` and `loads` make it.

    One thread at a time ticks, runs or halts it; another one that tries gets a RuntimeError. Keys
    of its blackboard are read and written as those of a dict, by any thread.
    """

    def __init__(self, program: _native.Program, clock: Clock, on_exception: str,
                 warnings: List[Diagnostic]) -> None:
        self._native = _native.Tree(program, clock, on_exception)
        self.clock = clock
        self.warnings = warnings
        self._watchers: List[Union[Recorder, Live]] = []
        _TREES.add(self)

    @property
    def id(self) -> str:
        """ID of the main tree."""
        return self._native.main_tree()

    def tick(self) -> Status:
        """One tick; returns what the root returned."""
        return self._native.tick()

    def run(self, *, period: Optional[float] = 0.1, fixed_rate: bool = False,
            forever: bool = False) -> Status:
        """Ticks until the root completes, then halts the tree; returns the last result.

        It is ticked when something happens, and every `period` seconds (None: only then), for
        leaves that poll; with `fixed_rate` at each multiple of the period and at no other time.
        `forever` begins anew when the root has completed. stop() ends it, from any thread. Ctrl+C
        on the main thread halts the tree and raises KeyboardInterrupt.
        """
        return self._native.run(period, fixed_rate, forever)

    def stop(self) -> None:
        """Ends run(), from any thread, and returns when the tree has been halted; in the tree's own
        thread (a leaf) at once."""
        self._native.stop()

    def halt(self) -> None:
        """Halts the tree: running leaves are told."""
        self._native.halt()

    def request_tick(self) -> None:
        """Any thread: the tree that runs is ticked soon."""
        self._native.request_tick()

    @property
    def is_running(self) -> bool:
        """Whether a thread is in run()."""
        return self._native.is_running()

    @property
    def status(self) -> Status:
        """Of the root."""
        return self._native.status()

    @property
    def ticks(self) -> int:
        """How often it was ticked."""
        return self._native.ticks()

    @property
    def next_tick(self) -> float:
        """When it wants the next tick at the latest, in its clock's time [s]; inf: when something
        happens."""
        return self._native.next_tick()

    @property
    def nodes(self) -> List[Node]:
        """All nodes in preorder, SubTrees written out in place."""
        return [Node(path, id, name, status, file, line, column)
                for (path, id, name, file, line, column), status
                in zip(self._native.nodes(), self._native.statuses())]

    def node(self, path: str) -> Node:
        """The node of that path or name. Raises KeyError."""
        nodes = self.nodes
        found = [node for node in nodes if path in (node.path, node.name)]
        if not found:
            known = [node.name for node in nodes] + [node.path for node in nodes]
            raise KeyError(f'the tree has no node "{path}"{nearest(path, known)}')
        if len(found) > 1:
            raise KeyError(f'several nodes are named "{path}": '
                           + ", ".join(node.path for node in found))
        return found[0]

    def keys(self) -> List[str]:
        """The keys that the main tree uses, written or not."""
        return self._native.keys()

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __contains__(self, key: object) -> bool:
        """Whether the key is used and has a value."""
        return key in self.keys() and self._native.is_set(str(key))

    def __getitem__(self, key: str) -> Any:
        """The value of a key; raises KeyError if there is no such key or nobody has written it."""
        if not self._native.is_set(key):
            raise KeyError(f'key "{key}" has no value yet')
        return self._native.get(key)

    def __setitem__(self, key: str, value: Any) -> None:
        """Writes a key, from any thread. While the tree is ticked, it counts from the next tick
        on. Raises KeyError, and TypeError or ValueError if the key has another type."""
        self._native.set(key, value)

    def get(self, key: str, default: Any = None) -> Any:
        """The value of a key, or the default if it has none yet."""
        return self._native.get(key) if self._native.is_set(key) else default

    def record(self, path: Path, metadata: Optional[Mapping[str, str]] = None) -> Recorder:
        """Records every tick from now on in a new file, until it is closed:

            with tree.record("run.coppice"):
                tree.run()
        """
        recorder = Recorder(self, path, metadata or {})
        self._watchers.append(recorder)
        return recorder

    def live(self, port: int = 1667, *, address: str = "127.0.0.1", token: str = "") -> Live:
        """Lets the editor, `coppice live` and Groot2 watch and debug the tree until it is closed.
        Port 0 takes a free one. All addresses but this computer's need a token (docs/live.md).
        Raises RuntimeError if the port cannot be had."""
        live = Live(self, port, address, token)
        self._watchers.append(live)
        return live

    def svg(self) -> str:
        """A picture of the tree, as `coppice export` makes it. Raises RuntimeError where that is
        not installed."""
        return svg_of(self._native.xml(), self.id)

    def _repr_svg_(self) -> Optional[str]:
        """The picture in a notebook."""
        try:
            return self.svg()
        except RuntimeError:
            return None

    def __repr__(self) -> str:
        return f"<coppice.Tree {self.id}: {self.status.name} after {self.ticks} ticks>"


class _Watcher:
    """What is closed at the end of a `with`."""

    def close(self) -> None:
        raise NotImplementedError

    def __enter__(self: W) -> W:
        return self

    def __exit__(self, kind: Optional[Type[BaseException]], error: Optional[BaseException],
                 traceback: Optional[TracebackType]) -> None:
        self.close()


class Recorder(_Watcher):
    """Records a tree in a file; see Tree.record. A record that is not closed is closed with the
    tree, or at the end of the program."""

    def __init__(self, tree: Tree, path: Path, metadata: Mapping[str, str]) -> None:
        self._native = _native.TreeRecorder(tree._native, os.fspath(path), dict(metadata))
        self.path = os.fspath(path)

    def note(self, kind: str, text: str) -> None:
        """Something that happened around the tree."""
        self._native.note(kind, text)

    def close(self) -> None:
        """Waits until everything is on the disk. Raises RuntimeError if something was lost."""
        self._native.close()


class Live(_Watcher):
    """A live view; see Tree.live."""

    def __init__(self, tree: Tree, port: int, address: str, token: str) -> None:
        if not hasattr(_native, "TreeLive"):
            raise RuntimeError("this module was built without the live view (COPPICE_LIVE)")
        self._native = _native.TreeLive(tree._native, port, address, token)

    @property
    def port(self) -> int:
        """Where it is served; 0: it is closed."""
        return self._native.port()

    def close(self) -> None:
        """Ends it."""
        self._native.close()


def close_watchers() -> None:
    """At the end of the program, when no tree is ticked any more."""
    for tree in list(_TREES):
        for watcher in tree._watchers:
            watcher.close()


def _tree(loaded: tuple, clock: Optional[Clock], on_exception: str) -> Tree:
    program, diagnostics = loaded
    if program is None:
        raise LoadError(diagnostics)
    return Tree(program, clock or WallClock(), on_exception, diagnostics)


def load(path: Path, leaves: Leaves = (), *, tree: str = "", clock: Optional[Clock] = None,
         on_exception: str = "fail") -> Tree:
    """Loads the main tree of a file, or the one with the ID `tree`.

    `leaves` are your node types. `on_exception` says what becomes of an exception in a leaf: "fail"
    fails the node, "halt" halts the whole tree, "raise" also raises it in tick() and run(). Raises
    LoadError with everything that is wrong.
    """
    loaded = _native.load_file(os.fspath(path), registry_of(leaves), tree)
    return _tree(loaded, clock, on_exception)


def loads(xml: str, leaves: Leaves = (), *, tree: str = "", clock: Optional[Clock] = None,
          on_exception: str = "fail", file: str = "text") -> Tree:
    """The same from a text; `file` is its name in messages, and includes are relative to it."""
    loaded = _native.load_text(xml, file, registry_of(leaves), tree)
    return _tree(loaded, clock, on_exception)


def check(paths: Union[Path, Sequence[Path]], leaves: Optional[Leaves] = None) -> List[Diagnostic]:
    """Everything that is wrong with these files, taken as one project. With `leaves`, node types
    that are neither there nor built in are errors; without, they are not checked."""
    single = isinstance(paths, (str, os.PathLike))
    files = [os.fspath(path) for path in ([paths] if single else paths)]  # type: ignore
    return _native.check_files(files, registry_of(leaves or ()), leaves is not None)


def checks(xml: str, leaves: Optional[Leaves] = None, *, file: str = "text") -> List[Diagnostic]:
    """The same of a text."""
    return _native.check_text(xml, file, registry_of(leaves or ()), leaves is not None)
