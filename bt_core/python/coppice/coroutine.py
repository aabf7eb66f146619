"""Leaves that are coroutines of asyncio.

    class Ask(AsyncAction):
        \"\"\"Asks a web service.\"\"\"
        url: Input[str] = Input("whom to ask")
        answer: Output[str] = Output("what it said")

        async def run(self) -> Status:
            async with session.get(self.url) as response:
                self.answer = await response.text()
            return Status.SUCCESS

The coroutine runs on the event loop of the package, in a thread of its own; its tree goes on
meanwhile. Inputs are those of the first tick; what it writes and says reaches the tree with the
next tick. When the leaf is halted the coroutine is cancelled, and the tree waits until it has ended.
"""
from __future__ import annotations

import asyncio
import concurrent.futures
import os
import threading
import traceback
from typing import Any, Callable, List, Optional, Tuple

from ._native import NodeLink, Status, UnsetInput
from .leaf import Action


class _Work:
    """A coroutine on its way, as another thread sees it."""

    def __init__(self, loop: asyncio.AbstractEventLoop, coroutine: Any,
                 on_end: Callable[[Any], None]) -> None:
        self._loop = loop
        self._coroutine = coroutine
        self._on_end = on_end
        self._task: Optional[asyncio.Task[_Result]] = None
        self.has_ended = False
        loop.call_soon_threadsafe(self._begin)

    def _begin(self) -> None:
        self._task = self._loop.create_task(_held(self._coroutine))
        self._task.add_done_callback(self._end)

    def _end(self, task: asyncio.Task[_Result]) -> None:
        self.has_ended = True
        self._on_end(True)

    def cancel(self) -> None:
        """Asks it to end."""
        def cancel() -> None:
            if self._task is not None:
                self._task.cancel()
        self._loop.call_soon_threadsafe(cancel)

    def result(self) -> Status:
        """Once it has ended. Raises what it raised."""
        assert self._task is not None
        ended, error = self._task.result()
        if error is not None:
            raise error
        status: Status = ended
        return status


_Result = Tuple[Any, Optional[BaseException]]


async def _held(coroutine: Any) -> _Result:
    """What came of it. SystemExit and its like would end the loop, and with it the coroutines of all
    other leaves; they are for the thread that ticks."""
    try:
        return await coroutine, None
    except (asyncio.CancelledError, GeneratorExit):
        raise
    except BaseException as error:  # pylint: disable=broad-except
        return None, error


class _Loop:
    """The event loop: begun when it is needed, ended with the program."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._loop: Optional[asyncio.AbstractEventLoop] = None
        self._thread: Optional[threading.Thread] = None
        self._is_ending = False

    def use(self, loop: asyncio.AbstractEventLoop) -> None:
        with self._lock:
            self._loop = loop

    def start(self, coroutine: Any, on_end: Callable[[Any], None]) -> _Work:
        with self._lock:
            if self._loop is None:
                self._loop = asyncio.new_event_loop()
                self._thread = threading.Thread(target=self._run, args=(self._loop,), daemon=True,
                                                name="coppice-asyncio")
                self._thread.start()
            return _Work(self._loop, coroutine, on_end)

    def _run(self, loop: asyncio.AbstractEventLoop) -> None:
        """What one leaf does to the loop, to stop it or to end the program in a callback, is no
        reason for the coroutines of all others to wait for ever."""
        while not self._is_ending:
            try:
                loop.run_forever()
            except (SystemExit, KeyboardInterrupt):
                traceback.print_exc()

    def forget(self) -> None:
        """In a copy of the process, which has not the thread."""
        self.__init__()  # type: ignore[misc]

    def end(self) -> None:
        with self._lock:
            if self._thread is None or self._loop is None:
                return
            ended = asyncio.run_coroutine_threadsafe(_cancel_all(), self._loop)
            concurrent.futures.wait([ended], timeout=5)
            self._is_ending = True
            self._loop.call_soon_threadsafe(self._loop.stop)
            self._thread.join(timeout=5)


async def _cancel_all() -> None:
    """All tasks of this loop but this one, which waits for them."""
    tasks = asyncio.all_tasks() - {asyncio.current_task()}
    for task in tasks:
        task.cancel()
    await asyncio.gather(*tasks, return_exceptions=True)


LOOP = _Loop()
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=LOOP.forget)


def use_event_loop(loop: asyncio.AbstractEventLoop) -> None:
    """Coroutines of leaves run on this loop, which runs in a thread other than those that tick."""
    LOOP.use(loop)


class _Snapshot:
    """What a coroutine sees in place of the node: inputs of its first tick; what it writes and says
    is kept until the next."""

    def __init__(self, node: NodeLink, ports: int) -> None:
        self._node = node
        self._values = [self._read(node, k) for k in range(ports)]
        self._set = [node.has_value(k) for k in range(ports)]
        self._writes = [node.writes(k) for k in range(ports)]
        self._now = node.now()
        self._path = node.path()
        self._lock = threading.Lock()
        self._orders: List[Tuple[Callable[..., None], tuple]] = []

    @staticmethod
    def _read(node: NodeLink, port: int) -> Any:
        try:
            return node.read(port)
        except UnsetInput as error:
            return error

    def read(self, port: int) -> Any:
        value = self._values[port]
        if isinstance(value, UnsetInput):
            raise value
        return value

    def has_value(self, port: int) -> bool:
        return self._set[port]

    def writes(self, port: int) -> int:
        return self._writes[port]

    def now(self) -> float:
        return self._now

    def path(self) -> str:
        return self._path

    def write(self, port: int, value: Any) -> None:
        self._values[port], self._set[port] = value, True
        self._order(self._node.write, port, value)

    def say(self, text: str) -> None:
        self._order(self._node.say, text)

    def _order(self, function: Callable[..., None], *arguments: Any) -> None:
        with self._lock:
            self._orders.append((function, arguments))
        self._node.request_tick()

    def carry_out(self) -> None:
        """On the ticking thread."""
        with self._lock:
            orders, self._orders = self._orders, []
        for function, arguments in orders:
            function(*arguments)


class AsyncAction(Action):
    """An action that is a coroutine."""
    _methods = ("_begin", "_go_on", "_cancel", "_has_ended")

    stop_limit = 5.0
    """How long a cancelled coroutine may take to end before the engine calls it a fault [s]."""

    _link: NodeLink
    _work: _Work

    async def run(self) -> Status:
        """Does it and returns the result."""
        raise NotImplementedError(f"{type(self).__name__} has no run()")

    @classmethod
    def _make(cls, node: NodeLink, arguments: tuple, keywords: dict) -> tuple:
        methods = super()._make(node, arguments, keywords)
        methods[0].__self__._link = node
        return methods

    def _begin(self) -> Status:
        send = self._link.new_sender()
        object.__setattr__(self, "_node", _Snapshot(self._link, len(self._ports)))
        coroutine = self.run()
        if not asyncio.iscoroutine(coroutine):
            raise TypeError(f"{type(self).__name__}.run() is no coroutine; expected async def run")
        self._work = LOOP.start(coroutine, send)
        return Status.RUNNING

    def _go_on(self) -> Status:
        has_ended = self._work.has_ended
        self._node.carry_out()  # type: ignore[attr-defined]
        if not has_ended:
            return Status.RUNNING
        try:
            return self._work.result()
        except asyncio.CancelledError:
            self._link.say("the coroutine was cancelled from outside")
            return Status.FAILURE

    def _cancel(self) -> None:
        self._work.cancel()
        self._link.drain_for(self.stop_limit)

    def _has_ended(self) -> bool:
        return self._work.has_ended
