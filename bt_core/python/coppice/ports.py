"""Typed ports as members of a leaf.

    lux: Input[float] = Input("brightness", unit="lx")
    limit: Input[float] = Input("dark below this", unit="lx", default=10.0)
    distance: Output[float] = Output("driven so far", unit="m")

A port is read and written as what it holds: `self.lux < self.limit`, `self.distance = 3.0`. The
annotation alone, `lux: Input[float]`, is a port too. `Input[Optional[float]]` may be left out in the
XML and is None then.
"""
from __future__ import annotations

import datetime
import typing
from typing import Any, Generic, List, NamedTuple, Optional, TypeVar, Union

from ._native import Status

T = TypeVar("T")


class Int64(int):
    """Annotation of a port with whole numbers of 64 bits; `int` has 32, as C++ leaves have."""


_MISSING: Any = object()

# What an annotation is on the blackboard; other classes are held as objects of Python.
_NAMES = {
    bool: "bool", int: "int", Int64: "int64", float: "double", str: "string", Status: "Status",
    datetime.timedelta: "duration",
    List[int]: "list of int", List[float]: "list of double",
    List[bool]: "list of bool", List[str]: "list of string",
    list[int]: "list of int", list[float]: "list of double",
    list[bool]: "list of bool", list[str]: "list of string",
}


class Declaration(NamedTuple):
    """What the engine gets to know of a port."""
    name: str
    direction: str
    type: Any
    description: str
    required: bool
    default: Optional[tuple]


class Port(Generic[T]):
    """A port of any direction."""
    direction = ""

    def __init__(self, description: str = "", *, unit: str = "", default: T = _MISSING) -> None:
        self.description = f"{description} [{unit}]".lstrip() if unit else description
        self.default = default
        self.name = ""
        self.number = -1

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __get__(self, leaf: Any, owner: Any = None) -> Any:
        return self if leaf is None else leaf._node.read(self.number)

    def __set__(self, leaf: Any, value: Any) -> None:
        leaf._node.write(self.number, value)

    def declare(self, annotation: Any, where: str) -> Declaration:
        """For the engine, of the port with this annotation. Raises TypeError."""
        kind, optional = _without_none(annotation)
        if self.direction != "input" and (optional or self.default is not _MISSING):
            raise TypeError(f"{where}: only an input can be left out or have a default")
        default = None if self.default is _MISSING or self.default is None else (self.default,)
        optional = optional or self.default is None
        required = self.direction != "output" and not optional and default is None
        named = _NAMES.get(kind, kind) if _is_hashable(kind) else kind
        if not isinstance(named, (str, type)) or typing.get_origin(named) is not None:
            raise TypeError(f"{where}: a port cannot be of type {kind}; a list has elements of "
                            "type int, float, bool or str, and any class goes as an object")
        if default is not None and not isinstance(named, str):
            raise TypeError(f"{where}: an object cannot be written in XML, so it is no default; "
                            f"{self.direction.capitalize()}[Optional[...]] may be left out")
        return Declaration(self.name, self.direction, named, self.description, required, default)


class Input(Port[T]):
    """A value that the leaf reads."""
    direction = "input"

    @typing.overload
    def __get__(self, leaf: None, owner: Any = None) -> Input[T]: ...
    @typing.overload
    def __get__(self, leaf: Any, owner: Any = None) -> T: ...

    def __get__(self, leaf: Any, owner: Any = None) -> Any:
        return self if leaf is None else leaf._node.read(self.number)

    def __set__(self, leaf: Any, value: Any) -> None:
        raise AttributeError(f"{type(leaf).__name__}.{self.name} is an input: it cannot be written")


class Output(Port[T]):
    """A value that the leaf writes; None as long as nobody has written the key."""
    direction = "output"

    def __init__(self, description: str = "", *, unit: str = "") -> None:
        super().__init__(description, unit=unit)

    @typing.overload
    def __get__(self, leaf: None, owner: Any = None) -> Output[T]: ...
    @typing.overload
    def __get__(self, leaf: Any, owner: Any = None) -> Optional[T]: ...

    def __get__(self, leaf: Any, owner: Any = None) -> Any:
        return self if leaf is None else leaf._node.read(self.number)

    def __set__(self, leaf: Any, value: T) -> None:
        leaf._node.write(self.number, value)


class InOut(Port[T]):
    """A value that the leaf reads and writes."""
    direction = "inout"

    def __init__(self, description: str = "", *, unit: str = "") -> None:
        super().__init__(description, unit=unit)

    @typing.overload
    def __get__(self, leaf: None, owner: Any = None) -> InOut[T]: ...
    @typing.overload
    def __get__(self, leaf: Any, owner: Any = None) -> T: ...

    def __get__(self, leaf: Any, owner: Any = None) -> Any:
        return self if leaf is None else leaf._node.read(self.number)

    def __set__(self, leaf: Any, value: T) -> None:
        leaf._node.write(self.number, value)


def _is_hashable(kind: Any) -> bool:
    try:
        hash(kind)
    except TypeError:
        return False
    return True


def _without_none(annotation: Any) -> tuple:
    """`Optional[float]` is (float, True), `float` is (float, False)."""
    arguments = typing.get_args(annotation)
    if type(None) not in arguments:
        return (object, False) if annotation is Any else (annotation, False)
    left = tuple(a for a in arguments if a is not type(None))
    return (left[0] if len(left) == 1 else Union[left]), True


def ports_of(cls: type, hints: dict) -> List[Declaration]:
    """The ports that the annotations of a class and its bases declare, in their order."""
    declared: List[Declaration] = []
    for name, hint in hints.items():
        kind = typing.get_origin(hint) or hint
        if not (isinstance(kind, type) and issubclass(kind, Port)):
            continue
        where = f"{cls.__name__}.{name}"
        arguments = typing.get_args(hint)
        if len(arguments) != 1:
            raise TypeError(f"{where}: say what it holds: {kind.__name__}[float]")
        port = getattr(cls, name, None)
        if not isinstance(port, kind):
            port = _port_from(kind, port, where)
            port.__set_name__(cls, name)
            setattr(cls, name, port)
        port.number = len(declared)
        declared.append(port.declare(arguments[0], where))
    return declared


def _port_from(kind: Any, value: Any, where: str) -> Any:
    if value is None:
        return kind()
    if isinstance(value, Port):
        raise TypeError(f"{where}: annotated as {kind.__name__}, but made as {type(value).__name__}")
    if issubclass(kind, Input):
        return kind(default=value)
    raise TypeError(f"{where}: only an input has a default")
