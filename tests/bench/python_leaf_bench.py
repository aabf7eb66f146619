#!/usr/bin/python3
"""What a leaf in Python costs, beside the same in C++ (a ScriptCondition): ns per tick of a leaf.

    PYTHONPATH=build/python tests/bench/python_leaf_bench.py
"""
import threading
import time

import coppice
from coppice import RUNNING, SUCCESS, Action, AsyncAction, Condition, Input, Output, SyncAction

LEAVES = 1000


class Nothing(Condition):
    def check(self):
        return True


class Reads(Condition):
    lux: Input[float] = 1.0

    def check(self):
        return self.lux < 2


class Writes(SyncAction):
    out: Output[float]

    def run(self):
        self.out = 1.0
        return SUCCESS


class Runs(Action):
    def on_start(self):
        return RUNNING

    def on_running(self):
        return RUNNING


class Returns(AsyncAction):
    async def run(self):
        return SUCCESS


def tree_of(leaf):
    return coppice.loads(f'<root BTCPP_format="4"><BehaviorTree ID="Main">'
                         f'<ParallelAll max_failures="-1">{leaf * LEAVES}</ParallelAll></BehaviorTree></root>',
                         [Nothing, Reads, Writes, Runs, Returns])


def nanoseconds(leaf, rounds=200):
    tree = tree_of(leaf)
    if "b" in tree.keys():
        tree["b"] = 1.0
    tree.tick()
    best = float("inf")
    for _ in range(5):
        begin = time.perf_counter_ns()
        for _ in range(rounds // 5):
            tree.tick()
        best = min(best, (time.perf_counter_ns() - begin) / (rounds // 5) / LEAVES)
    return best


def coroutine_microseconds(rounds=200):
    tree = coppice.loads('<root BTCPP_format="4"><BehaviorTree ID="Main"><Returns/></BehaviorTree>'
                         '</root>', [Returns])
    begin = time.perf_counter()
    for _ in range(rounds):
        tree.run(period=None)
    return (time.perf_counter() - begin) / rounds * 1e6


def main():
    for what, leaf in (("AlwaysSuccess, in C++", "<AlwaysSuccess/>"),
                       ("ScriptCondition, in C++", '<ScriptCondition code="b &lt; 2"/>'),
                       ("Condition in Python", "<Nothing/>"),
                       ("Condition that reads a port", '<Reads lux="{b}"/>'),
                       ("SyncAction that writes a port", '<Writes out="{o}"/>'),
                       ("Action that runs", "<Runs/>")):
        print(f"{what:34}{nanoseconds(leaf):8.0f} ns")
    stop = threading.Event()
    threading.Thread(target=lambda: [None for _ in iter(stop.is_set, True)], daemon=True).start()
    print(f"{'Condition, beside a busy thread':34}{nanoseconds('<Nothing/>', 5):8.0f} ns")
    stop.set()
    print(f"{'AsyncAction, begun and ended':34}{coroutine_microseconds():8.0f} us")


if __name__ == "__main__":
    main()
