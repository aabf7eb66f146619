#!/usr/bin/python3
"""Drives to a pose with the tree that the robot ships, and leaves in Python beside ROS.

    coppice-simulator & coppice-navigation &        # or a robot with move_base
    drive_to.py trees/behavior/drive_to.xml 5.2 0 0 --record drive.coppice

Ctrl+C halts the tree: the goal is cancelled, the robot stops. docs/python.md explains the leaves.
"""
import argparse
import contextlib
import math
import sys

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from move_base_msgs.msg import MoveBaseAction, MoveBaseGoal

import coppice
from coppice import RUNNING, SUCCESS, Action, Input, Status


class NavigateTo(Action):
    """Drives to a pose on the map."""
    goal: Input[list[float]] = Input("where to, in map: x, y, yaw", unit="m, m, rad")

    def __init__(self, client):
        self.client = client

    def on_start(self):
        answer = self.new_sender()  # called on a thread of rospy
        self.client.send_goal(move_base_goal(*self.goal), done_cb=lambda state, _: answer(
            (state, self.client.get_goal_status_text())))
        return RUNNING

    def on_running(self):
        answer = self.take()
        if answer is None:
            return RUNNING
        state, text = answer
        return SUCCESS if state == GoalStatus.SUCCEEDED else self.fail(text)

    def on_halted(self):
        self.client.cancel_goal()
        self.drain_for(5)  # until the robot says that it has stopped

    def on_draining(self):
        return self.take() is not None


class Wait(Action):
    """Does nothing for a while."""
    seconds: Input[float] = Input("how long", unit="s")

    def on_start(self):
        self.until = self.now + self.seconds
        return self.on_running()

    def on_running(self):
        if self.now >= self.until:
            return SUCCESS
        self.wake_at(self.until)
        return RUNNING


def move_base_goal(x, y, yaw):
    goal = MoveBaseGoal()
    goal.target_pose.header.frame_id = "map"
    goal.target_pose.pose.position.x = x
    goal.target_pose.pose.position.y = y
    goal.target_pose.pose.orientation.z = math.sin(yaw / 2)
    goal.target_pose.pose.orientation.w = math.cos(yaw / 2)
    return goal


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tree", help="the XML file")
    parser.add_argument("pose", type=float, nargs=3, metavar=("X", "Y", "YAW"),
                        help="in the frame map [m, m, rad]")
    parser.add_argument("--record", metavar="OUT.coppice", help="writes every tick into a file")
    arguments = parser.parse_args(rospy.myargv()[1:])

    # Else Ctrl+C would end the node of ROS before the leaves have cancelled their goals.
    rospy.init_node("drive_to", anonymous=True, disable_signals=True)
    client = actionlib.SimpleActionClient("move_base", MoveBaseAction)
    client.wait_for_server()

    registry = coppice.Registry([Wait])
    registry.register(NavigateTo, client)
    tree = coppice.load(arguments.tree, registry)
    tree["goal"] = arguments.pose
    recording = tree.record(arguments.record) if arguments.record else contextlib.nullcontext()
    try:
        with recording:
            result = tree.run(period=None)
    except KeyboardInterrupt:
        print("interrupted")
        return 130
    print(result.name)
    return 0 if result == Status.SUCCESS else 1


if __name__ == "__main__":
    sys.exit(main())
