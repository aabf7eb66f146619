"""Base classes of leaves: what a user derives from.

    class IsDark(Condition):
        \"\"\"Is it dark?\"\"\"
        lux: Input[float] = Input("how bright it is", unit="lx")

        def check(self) -> bool:
            return self.lux < 10

The docstring is the description. All methods are called on the ticking thread and must return soon:
what takes time is begun in on_start and reported through a sender, or is a coroutine. A leaf that
raises fails; the traceback becomes its message.
"""
from __future__ import annotations

import inspect
import pathlib
import sys
import traceback
import typing
from typing import Any, Callable, ClassVar, FrozenSet, List, Optional, Tuple

from . import _native
from ._native import NodeLink, Status
from .ports import Declaration, InOut, Input, Output, Port, ports_of

_PACKAGE = str(pathlib.Path(__file__).parent)


def format_error(error: BaseException) -> str:
    """The traceback without the frames of this package."""
    told = traceback.TracebackException.from_exception(error)
    told.stack[:] = [f for f in told.stack if not f.filename.startswith(_PACKAGE)]
    return "".join(told.format()).rstrip()


def _hints_of(cls: type) -> dict:
    """Annotations of the class and its bases; names of the function that defines it are known."""
    names: dict = {}
    frame: Any = sys._getframe(2)
    while frame is not None:  # the innermost definition counts
        for name, value in frame.f_locals.items():
            names.setdefault(name, value)
        frame = frame.f_back if frame.f_code.co_name != "<module>" else None
    try:
        return typing.get_type_hints(cls, localns=names)
    except NameError as error:
        raise TypeError(f"{cls.__name__}: an annotation names what is not known: {error}") from None


def nearest(name: str, known: List[str]) -> str:
    """' (did you mean "lux"?)', or nothing."""
    found = _native.nearest_name(name, known)
    return f' (did you mean "{found}"?)' if found else ""


class Leaf:
    """What all nodes have in common. Derive from Condition, SyncAction, Action or AsyncAction, or
    from Control and Decorator."""
    _node: NodeLink
    _ports: ClassVar[Tuple[Declaration, ...]] = ()
    _known: ClassVar[FrozenSet[str]] = frozenset()  # what may be assigned, however it is spelt
    _category: ClassVar[str] = "action"
    _methods: ClassVar[Tuple[str, ...]] = ()

    def __init_subclass__(cls, **keywords: Any) -> None:
        super().__init_subclass__(**keywords)
        hints = _hints_of(cls)
        cls._ports = tuple(ports_of(cls, hints))
        cls._known = frozenset(dir(cls)) | frozenset(hints)
        for name, value in vars(cls).items():
            if isinstance(value, Port) and name not in {port.name for port in cls._ports}:
                raise TypeError(f"{cls.__name__}.{name}: say what it holds: "
                                f"{name}: {type(value).__name__}[float] = ...")

    @classmethod
    def description(cls) -> str:
        """The docstring, without those of the base classes."""
        return inspect.cleandoc(cls.__doc__) if cls.__doc__ else ""

    @classmethod
    def _make(cls, node: NodeLink, arguments: tuple, keywords: dict) -> tuple:
        leaf = cls.__new__(cls)
        object.__setattr__(leaf, "_node", node)
        leaf.__init__(*arguments, **keywords)  # type: ignore[misc]
        return tuple(getattr(leaf, name) if name else None for name in cls._methods)

    def __getattr__(self, name: str) -> Any:
        ports = [port.name for port in self._ports]
        raise AttributeError(f"{type(self).__name__} has neither port nor attribute "
                             f'"{name}"{nearest(name, ports)}')

    def __setattr__(self, name: str, value: Any) -> None:
        if name not in self._known and name[0] != "_" and name not in self.__dict__:
            near = _native.nearest_name(name, [p.name for p in self._ports
                                               if p.direction != "input"])
            if near:
                raise AttributeError(
                    f'{type(self).__name__} has no output "{name}" (did you mean "{near}"?); an '
                    "attribute of that name is declared in the class")
        object.__setattr__(self, name, value)

    @property
    def now(self) -> float:
        """The time of the tree's clock at which this tick began [s]."""
        return self._node.now()

    @property
    def path(self) -> str:
        """Where the node is in the tree: "Main/patrol/drive"."""
        return self._node.path()

    def say(self, text: str) -> None:
        """Why the leaf does what it does, for people: in the live view and in the record."""
        self._node.say(text)

    def fail(self, reason: str) -> Status:
        """Status.FAILURE, and says why."""
        self._node.say(reason)
        return Status.FAILURE

    def is_set(self, port: str) -> bool:
        """Whether the port of that name has a value."""
        return self._node.has_value(self._number(port))

    def writes(self, port: str) -> int:
        """Counts the writes of the port's key; a change means that somebody wrote it."""
        return self._node.writes(self._number(port))

    def _number(self, name: str) -> int:
        names = [port.name for port in self._ports]
        if name not in names:
            raise KeyError(f'{type(self).__name__} has no port "{name}"{nearest(name, names)}')
        return names.index(name)


class Condition(Leaf):
    """A question about the world, answered at once."""
    _category = "condition"
    _methods = ("check", "check", "", "")

    def check(self) -> bool:
        """Whether it is so."""
        raise NotImplementedError(f"{type(self).__name__} has no check()")


class SyncAction(Leaf):
    """An action that is done within one tick."""
    _methods = ("run", "run", "", "")

    def run(self) -> Status:
        """Does it and returns the result."""
        raise NotImplementedError(f"{type(self).__name__} has no run()")


class Action(Leaf):
    """An action that takes more than one tick. It is ticked when an answer or a wake-up time comes,
    and at the period of the loop that runs the tree."""
    _methods = ("on_start", "on_running", "on_halted", "on_draining")

    def on_start(self) -> Status:
        """First tick of an activation."""
        raise NotImplementedError(f"{type(self).__name__} has no on_start()")

    def on_running(self) -> Status:
        """Every further tick while it returned RUNNING."""
        raise NotImplementedError(f"{type(self).__name__} has no on_running()")

    def on_halted(self) -> None:
        """The activation ends before the action does: stop it. What takes several ticks to stop
        calls drain_for here."""

    def on_draining(self) -> bool:
        """True when the action has stopped. Asked in each tick after drain_for."""
        return True

    def wake_at(self, time: float) -> None:
        """Asks for a tick at that time of the tree's clock at the latest [s]. Holds until the next
        tick."""
        self._node.wake_at(time)

    def wake_after(self, seconds: float) -> None:
        """The same, so long after now."""
        self._node.wake_after(seconds)

    def drain_for(self, seconds: float) -> None:
        """In on_halted: it needs so long to stop; on_draining is asked meanwhile."""
        self._node.drain_for(seconds)

    def new_sender(self) -> Callable[[Any], None]:
        """A function that any thread may call with an answer, which wakes the tree. What senders of
        earlier questions send is dropped."""
        return self._node.new_sender()

    def take(self) -> Optional[Any]:
        """The newest answer since the last call, or None."""
        return self._node.take()
