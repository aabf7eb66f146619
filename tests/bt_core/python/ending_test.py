"""How programs end: by Ctrl+C, with trees that run, with leaves that do not return."""
import signal
import subprocess
import sys

import coppice

COMMON = """
import os, signal, sys, threading, time
import coppice
from coppice import *

class Hold(Action):
    def on_start(self):
        print("start", flush=True)
        return RUNNING
    def on_running(self):
        return RUNNING
    def on_halted(self):
        print("halt", flush=True)

tree = coppice.loads('<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence><Hold/>'
                     '<AlwaysSuccess/></Sequence></BehaviorTree></root>', [Hold])
"""


def program(text):
    return subprocess.Popen([sys.executable, "-c", COMMON + text], stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True)


def lines_of(process):
    out, error = process.communicate(timeout=60)
    return out.splitlines(), error


def test_ctrl_c_halts_the_leaves_and_raises():
    process = program("""
try:
    tree.run()
except KeyboardInterrupt:
    print("interrupted", tree.status.name)
""")
    assert process.stdout.readline() == "start\n"
    process.send_signal(signal.SIGINT)
    assert lines_of(process) == (["halt", "interrupted IDLE"], "")
    assert process.returncode == 0


def test_ctrl_c_in_the_midst_of_a_leaf_halts_it():
    process = program("""
class Busy(Hold):
    def on_running(self):
        while True:
            pass
tree = coppice.loads('<root BTCPP_format="4"><BehaviorTree ID="Main"><Fallback><Busy/><Hold/>'
                     '</Fallback></BehaviorTree></root>', [Busy, Hold])
try:
    tree.run(period=0.001)
except KeyboardInterrupt:
    print("interrupted")
""")
    assert process.stdout.readline() == "start\n"
    process.send_signal(signal.SIGINT)
    assert lines_of(process) == (["halt", "interrupted"], "")


def test_a_handler_of_the_program_is_called_behind_the_run():
    process = program("""
signal.signal(signal.SIGTERM, lambda *_: print("terminated", tree.status.name))
print("ended", tree.run().name)
""")
    assert process.stdout.readline() == "start\n"
    process.send_signal(signal.SIGTERM)
    out, error = lines_of(process)
    assert sorted(out) == ["ended RUNNING", "halt", "terminated IDLE"] and error == ""


def test_a_tree_that_runs_in_a_daemon_is_halted_at_the_end():
    out, error = lines_of(program("""
threading.Thread(target=tree.run, daemon=True).start()
while tree.status != RUNNING:
    pass
"""))
    assert (out, error) == (["start", "halt"], "")


def test_a_tree_that_stands_in_the_midst_of_a_run_is_halted_at_the_end():
    process = program("tree.tick()")
    assert lines_of(process) == (["start", "halt"], "")
    assert process.returncode == 0


def test_a_daemon_that_ticks_again_and_again_does_not_crash_the_end():
    process = program("""
def tick():
    try:
        while True:
            tree.tick()
    except RuntimeError as error:
        print(error, flush=True)
threading.Thread(target=tick, daemon=True).start()
while tree.status != RUNNING:
    pass
""")
    out, error = lines_of(process)
    assert process.returncode == 0 and error == "" and "halt" in "".join(out)


def test_a_record_is_closed_at_the_end(tmp_path):
    lines_of(program(f"""
tree.record({str(tmp_path / "run.coppice")!r})
threading.Thread(target=tree.run, daemon=True).start()
while tree.status != RUNNING:
    pass
"""))
    assert coppice.open_record(tmp_path / "run.coppice").is_closed


def test_a_coroutine_that_waits_is_cancelled_at_the_end():
    process = program("""
import asyncio
class Wait(AsyncAction):
    async def run(self):
        print("waits", flush=True)
        try:
            await asyncio.sleep(1000)
        finally:
            print("cancelled", flush=True)
tree = coppice.loads('<root BTCPP_format="4"><BehaviorTree ID="Main"><Wait/></BehaviorTree></root>',
                     [Wait])
threading.Thread(target=tree.run, daemon=True).start()
while tree.status != RUNNING:
    pass
""")
    out, error = lines_of(process)
    assert process.returncode == 0 and error == "" and out in ([], ["waits", "cancelled"])


def test_a_copy_of_the_process_has_coroutines_of_its_own():
    process = program("""
import asyncio
class Wait(AsyncAction):
    async def run(self):
        await asyncio.sleep(0.001)
        return SUCCESS
def run():
    tree = coppice.loads('<root BTCPP_format="4"><BehaviorTree ID="Main"><Wait/></BehaviorTree>'
                         '</root>', [Wait])
    print(tree.run(), flush=True)
run()
copy = os.fork()
run()
if copy:
    os.waitpid(copy, 0)
""")
    out, error = lines_of(process)
    assert process.returncode == 0 and error == "" and out == ["Status.SUCCESS"] * 3
