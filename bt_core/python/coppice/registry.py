"""The node types that a tree may use: those of the engine, and yours."""
from __future__ import annotations

import enum
import inspect
import os
import typing
from typing import Any, Callable, Dict, Iterable, List, Optional, Type, TypeVar, Union, overload

from . import _native
from ._native import Status
from .leaf import Condition, Leaf, SyncAction
from .ports import Input

F = TypeVar("F", bound=Callable[..., Any])
E = TypeVar("E", bound=Type[enum.Enum])


class Registry:
    """Built-in node types, and leaves that are added.

        registry = Registry()
        registry.register(IsDark)
        registry.register(DriveTo, navigator)     # arguments of its __init__

        @registry.condition
        def is_night(hour: int) -> bool:
            return hour < 6

    A tree takes the types that are there when it is loaded.
    """

    def __init__(self, leaves: Iterable[Type[Leaf]] = ()) -> None:
        self._native = _native.Registry()
        for leaf in leaves:
            self.register(leaf)

    def register(self, leaf: Type[Leaf], *arguments: Any, id: str = "", **keywords: Any) -> None:
        """Adds a class of leaves; each node of it is made with these arguments. `id` is its name in
        XML, else that of the class. Raises ValueError if the name is taken."""
        if not (isinstance(leaf, type) and issubclass(leaf, Leaf)):
            raise TypeError(f"{leaf!r} is no class of leaves; register functions with "
                            "@registry.condition or @registry.action")
        if not leaf._methods:
            raise TypeError(f"{leaf.__name__} derives from Leaf; derive it from Condition, "
                            "SyncAction, Action, AsyncAction, Control or Decorator")
        if not all(leaf._methods[:2]):
            raise TypeError(f"{leaf.__name__} has no method that is called when it is ticked: "
                            "does it have _methods of its own?")
        self._native.add_node(
            id or leaf.__name__, leaf._category, leaf.description(), list(leaf._ports),
            lambda node: leaf._make(node, arguments, keywords))

    @overload
    def condition(self, function: F) -> F: ...
    @overload
    def condition(self, *, id: str = "") -> Callable[[F], F]: ...

    def condition(self, function: Optional[F] = None, *, id: str = "") -> Any:
        """Adds a function that returns a bool. Its parameters are inputs; the name in XML is that
        of the function."""
        return self._add_function(function, Condition, "check", id)

    @overload
    def action(self, function: F) -> F: ...
    @overload
    def action(self, *, id: str = "") -> Callable[[F], F]: ...

    def action(self, function: Optional[F] = None, *, id: str = "") -> Any:
        """Adds a function that is done at once and returns a Status; else the same."""
        return self._add_function(function, SyncAction, "run", id)

    def _add_function(self, function: Optional[F], base: type, method: str, id: str) -> Any:
        def add(given: F) -> F:
            self.register(_class_of(given, base, method), id=id or given.__name__)
            return given
        return add if function is None else add(function)

    def enum(self, kind: E) -> E:
        """Makes the names of an enum stand for their numbers in every script of a tree. Raises
        ValueError if a name stands for another number already.

            @registry.enum
            class Colour(enum.IntEnum):
                RED = 1
        """
        members: Dict[str, enum.Enum] = dict(kind.__members__)
        for name, member in members.items():
            if not isinstance(member.value, int):
                raise TypeError(f"{kind.__name__}.{name} is {member.value!r}; scripts know the "
                                "names of whole numbers")
            self._native.add_script_constant(name, member.value)
        return kind

    def load_plugin(self, path: Union[str, os.PathLike]) -> None:
        """Adds the node types of a shared library of C++ (bt_core/engine/plugin.h). Raises
        RuntimeError."""
        self._native.load_plugin(os.fspath(path))

    def ids(self) -> List[str]:
        """All names, in alphabetical order."""
        return self._native.ids()

    def models(self) -> str:
        """All node types as <TreeNodesModel>: the palette of the editor, and what
        `coppice check --models` takes."""
        return self._native.models()

    def write_models(self, path: Union[str, os.PathLike]) -> None:
        """Writes models() into a file."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.models())

    def describe(self) -> str:
        """All node types and their ports, for people."""
        return self._native.describe()

    def __contains__(self, id: str) -> bool:
        return id in self.ids()

    def __repr__(self) -> str:
        own = sorted(set(self.ids()) - set(_native.Registry().ids()))
        return f"<coppice.Registry with {', '.join(own) or 'the built-in nodes'}>"


def _class_of(function: Callable[..., Any], base: type, method: str) -> Type[Leaf]:
    hints = typing.get_type_hints(function)
    members: dict = {"__annotations__": {}, "__doc__": function.__doc__ or "",
                     "__module__": function.__module__}
    for name, parameter in inspect.signature(function).parameters.items():
        if parameter.kind not in (parameter.POSITIONAL_OR_KEYWORD, parameter.KEYWORD_ONLY):
            raise TypeError(f"{function.__name__}: *{name} can be no port")
        if name not in hints:
            raise TypeError(f"{function.__name__}: say of which type {name} is")
        members["__annotations__"][name] = Input[hints[name]]  # type: ignore[valid-type]
        has_default = parameter.default is not parameter.empty
        members[name] = Input(default=parameter.default) if has_default else Input()
    names = list(members["__annotations__"])

    def call(self: Leaf) -> Any:
        return function(**{name: getattr(self, name) for name in names})
    call.__qualname__ = function.__qualname__
    members[method] = call
    return type(function.__name__, (base,), members)


Leaves = Union[Registry, Iterable[Type[Leaf]]]


def registry_of(leaves: Leaves) -> _native.Registry:
    """Of what functions take as `leaves`."""
    if isinstance(leaves, Registry):
        return leaves._native
    if isinstance(leaves, type):
        raise TypeError(f"leaves are a Registry or a list of classes: [{leaves.__name__}]")
    return Registry(leaves)._native
