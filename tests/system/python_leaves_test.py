#!/usr/bin/python3
"""Leaves in Python beside ROS: python_leaves_test.py PROGRAMS SOURCE. The example of robot_app drives the
simulated robot with a shipped tree, and lets it stop when it is interrupted."""
import os
import pathlib
import random
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import unittest

import rosgraph
import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import PoseStamped, Twist
from move_base_msgs.msg import MoveBaseActionResult

import coppice

PROGRAMS, SOURCE = (pathlib.Path(path) for path in sys.argv[1:3])
EXAMPLE = SOURCE / "robot_app/examples/drive_to.py"
TREE = SOURCE / "trees/behavior/drive_to.xml"
PATIENCE = 60  # for whatever is waited for [s]


def free_port():
    """Below those that Linux gives to whoever connects, which may be taken before it is used."""
    while True:
        port = random.randrange(12000, 32000)
        with socket.socket() as one:
            if one.connect_ex(("127.0.0.1", port)) != 0:
                return port


class Robot:
    """A master, the simulator at six times real time, the navigation."""

    def __init__(self, folder):
        self.folder = folder
        self.processes = []
        port = free_port()
        os.environ.update(ROS_MASTER_URI=f"http://127.0.0.1:{port}", ROS_IP="127.0.0.1",
                          ROS_HOME=str(folder), ROS_LOG_DIR=str(folder))
        self.start("/usr/bin/rosmaster", "--core", "-p", str(port))
        self.wait_for_master(port)
        rosgraph.Master("/test").setParam("/use_sim_time", True)
        self.start(PROGRAMS / "coppice-simulator", "_speed:=6", "_start:=4 0 0",
                   "_state_of_charge:=0.5")
        self.start(PROGRAMS / "coppice-navigation")

    def start(self, *command):
        with open(self.folder / f"{pathlib.Path(command[0]).name}.log", "w") as log:
            self.processes.append(subprocess.Popen(list(map(str, command)), stdout=log,
                                                   stderr=subprocess.STDOUT))

    def wait_for_master(self, port):
        while self.processes[0].poll() is None:
            with socket.socket() as one:
                if one.connect_ex(("127.0.0.1", port)) == 0:
                    return
        raise RuntimeError("no ROS master")

    def stop(self):
        for process in reversed(self.processes):
            process.terminate()
            process.wait(PATIENCE)


class PythonLeavesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.robot = Robot(pathlib.Path(cls.folder.name))
        cls.addClassCleanup(cls.folder.cleanup)
        cls.addClassCleanup(cls.robot.stop)
        rospy.init_node("test", disable_signals=True)

    def drive(self, name, *pose):
        self.record = os.path.join(self.folder.name, name)
        with open(self.record + ".log", "w") as log:  # actionlib says more than there is to say
            return subprocess.Popen([sys.executable, EXAMPLE, TREE, *map(str, pose),
                                     "--record", self.record],
                                    stdout=subprocess.PIPE, stderr=log, text=True)

    def test_a_shipped_tree_drives_the_robot_there(self):
        program = self.drive("there.coppice", 5.2, 0, 0)
        out, _ = program.communicate(timeout=PATIENCE)
        self.assertEqual((out, program.returncode), ("SUCCESS\n", 0))
        truth = rospy.wait_for_message("/simulation/truth", PoseStamped)
        self.assertAlmostEqual(truth.pose.position.x, 5.2, delta=0.3)
        ticked = [c for tick in coppice.open_record(self.record) for c in tick.changes
                  if "NavigateTo" in c.node]
        self.assertEqual([c.after.name for c in ticked][:2], ["RUNNING", "SUCCESS"])

    def test_the_robot_stops_when_the_program_is_interrupted(self):
        moving, results, ended = threading.Event(), [], threading.Event()
        command = rospy.Subscriber("/cmd_vel", Twist, lambda message: (
            moving.set() if message.linear.x > 0.1 else None))
        result = rospy.Subscriber("/move_base/result", MoveBaseActionResult, lambda message: (
            results.append(message.status.status), ended.set()))
        program = self.drive("halted.coppice", 0.5, 0, 0)
        self.assertTrue(moving.wait(PATIENCE))
        program.send_signal(signal.SIGINT)
        out, _ = program.communicate(timeout=PATIENCE)
        self.assertTrue(ended.wait(PATIENCE))
        self.assertEqual(results, [GoalStatus.PREEMPTED])
        self.assertEqual((out, program.returncode), ("interrupted\n", 130))
        command.unregister()
        result.unregister()


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], warnings="ignore")  # those of rospy
