#!/usr/bin/python3
"""Holds the accelerated robot of coppice-deployment against the whole robot under ROS.

    bridge.py --programs build/bin --out runs/bridge --seed 1 --hours 2 --speed 3

Lets the seed live the first hours of the deployment, and 20 seeds from it on for what chance does; then starts the
robot as its users do (coppice-supervisor, robot.yaml) in the simulated institute and breaks the same things at the same
times. bridge.md tells the recoveries by kind, the distance and the energy of both. Only loopback; all that it starts it
ends.
"""
import argparse
import collections
import json
import math
import os
import pathlib
import re
import socket
import subprocess
import sys
import tempfile
import threading
import time

SOURCE = pathlib.Path(__file__).resolve().parents[3]
CAPACITY = 75  # of the battery [Ah]
SEEDS = 20
PLACES = {"corridor_west": 10, "corridor_middle": 20, "corridor_east": 30, "hall_entrance": 39.4}  # x [m]
TRAP_LASTS = 60  # s; in the simulated robot nothing but time opens one
TOPIC_LASTS = 15  # s
KINDS = ["wait and retry", "move backwards", "wait longer", "slow rotate", "restart localization and rotate",
         "restart node"]


# ---- the accelerated robot

def scenario_of(hours, folder):
    text = (SOURCE / "robot_app/deployment/scenario/scenario.yaml").read_text()
    end = time.strftime("%H:%M", time.gmtime(13 * 3600 + hours * 3600))
    file = folder / "scenario.yaml"
    file.write_text(re.sub(r'end: "[^"]*"', f'end: "2021-03-02 {end}"', text))
    return file


def live_accelerated(options, folder):
    last = options.seed + SEEDS - 1
    subprocess.run([options.programs / "coppice-deployment", "run", "--seeds", f"{options.seed}-{last}", "--scenario",
                    scenario_of(options.hours, folder), "--out", folder / "accelerated"], check=True)
    files = sorted((folder / "accelerated/ours").glob("seed-*.json"))
    return [json.loads(file.read_text()) for file in files]


def figures_of_journal(journal):
    begun = collections.Counter(e["recovery"] for e in journal["recoveries"] if e["phase"] == 0)
    (first, full), (last, left) = journal["battery"][0], journal["battery"][-1]  # a sample each ten minutes
    begin, end = journal["span"]
    energy = (full - left) * CAPACITY * (end - begin) / max(last - first, 1)
    return {**{kind: begun[kind] for kind in KINDS}, "requests": len(journal["requests"]),
            "distance [km]": journal["distance"] / 1000, "energy [Ah]": energy}


# ---- the whole robot

class Robot:
    """As its users start it, watched by its topics."""

    def __init__(self, options, folder):
        command = [options.programs / "coppice-supervisor", "--config", SOURCE / "robot_app/config/robot.yaml",
                   "--port", "0", "--port-file", folder / "ros_port", "--logs", folder / "logs"]
        values = {"bin": options.programs, "source": SOURCE, "record": folder, "speed": options.speed,
                  "perception": "no", "seed": options.seed, "rounds": -1, "stops": 4, "live_port": 0,
                  "state_of_charge": 1, "page_port": free_port(), "tablet_port": free_port()}
        for name, value in values.items():
            command += ["--set", f"{name}={value}"]
        (folder / "logs").mkdir(parents=True, exist_ok=True)
        with open(folder / "logs/supervisor.log", "w", encoding="utf-8") as log:
            self.process = subprocess.Popen(list(map(str, command)), stdout=log, stderr=subprocess.STDOUT)
        self.lock = threading.Lock()
        self.begun = collections.Counter()
        self.requests = set()
        self.x = self.y = self.yaw = self.goal_x = self.distance = self.now = 0.0
        self.level = None
        self.last = None

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self.process.terminate()
        try:
            self.process.wait(60)
        except subprocess.TimeoutExpired:
            self.process.kill()

    def connect(self, folder):
        port_file = folder / "ros_port"
        wait_until(lambda: port_file.exists() and port_file.read_text().strip(), 60, "no ROS master")
        os.environ.update(ROS_MASTER_URI=f"http://127.0.0.1:{port_file.read_text().strip()}", ROS_IP="127.0.0.1")
        messages = generate_messages(folder)
        sys.path.insert(0, str(messages))
        import rospy
        from coppice_msgs.msg import HelpRequests, RecoveryEvent
        from coppice_msgs.srv import InjectFault
        from geometry_msgs.msg import PoseStamped
        from move_base_msgs.msg import MoveBaseActionGoal
        from sensor_msgs.msg import BatteryState
        rospy.init_node("bridge", disable_signals=True)
        rospy.Subscriber("/recovery/events", RecoveryEvent, self.on_recovery)
        rospy.Subscriber("/assistance/requests", HelpRequests, self.on_requests)
        rospy.Subscriber("/simulation/truth", PoseStamped, self.on_truth)
        rospy.Subscriber("/move_base/goal", MoveBaseActionGoal, self.on_goal)
        rospy.Subscriber("/battery_state", BatteryState, self.on_battery)
        rospy.wait_for_service("/simulation/inject_fault", 60)
        self.service = rospy.ServiceProxy("/simulation/inject_fault", InjectFault)

    def on_recovery(self, event):
        with self.lock:
            if event.phase == event.BEGUN:
                self.begun[event.recovery] += 1

    def on_requests(self, message):
        with self.lock:
            self.requests |= {request.id for request in message.requests}

    def on_truth(self, message):
        turn, place = message.pose.orientation, (message.pose.position.x, message.pose.position.y)
        if self.last is not None:
            self.distance += math.dist(place, self.last)
        self.last = self.x, self.y = place
        self.yaw = 2 * math.atan2(turn.z, turn.w)
        self.now = message.header.stamp.to_sec()

    def on_goal(self, message):
        self.goal_x = message.goal.target_pose.pose.position.x

    def on_battery(self, message):
        self.level = message.percentage

    def inject(self, fault, target="", value=0.0, duration=0.0):
        answer = self.service(fault, target, value, duration)
        return answer.ok

    def place_ahead(self):
        """Of the places that can be blocked one on the way to the goal, not too near to either end."""
        low, high = sorted((self.x, self.goal_x))
        ahead = [(abs(x - self.x), name) for name, x in PLACES.items() if low + 2.5 < x < high - 2.5]
        return min(ahead)[1] if ahead else None


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


def wait_until(is_true, seconds, problem):
    deadline = time.monotonic() + seconds
    while not is_true():
        if time.monotonic() > deadline:
            raise RuntimeError(problem)
        time.sleep(0.2)


def generate_messages(folder):
    """Python classes of messages that Debian has none of, made by genpy."""
    out = folder / "python"
    own = SOURCE / "robot_app"
    includes = [f"-Icoppice_msgs:{own / 'msg'}"]
    includes += [f"-I{name}:/usr/share/{name}/msg" for name in ("std_msgs", "geometry_msgs", "sensor_msgs")]
    for package, kind, files in (("coppice_msgs", "msg", own / "msg"), ("coppice_msgs", "srv", own / "srv"),
                                 ("sensor_msgs", "msg", pathlib.Path("/usr/share/sensor_msgs/msg"))):
        target = out / package / kind
        target.mkdir(parents=True, exist_ok=True)
        (out / package / "__init__.py").touch()
        generator = ["/usr/bin/python3", f"/usr/lib/genpy/gen{kind}_py.py"]
        where = ["-p", package, "-o", str(target)]
        subprocess.run([*generator, *map(str, sorted(files.glob(f"*.{kind}"))), *includes, *where], check=True,
                       stdout=subprocess.DEVNULL)
        subprocess.run([*generator, "--initpy", *where], check=True)
    return out


def break_it(robot, fault):
    """False: not now, as the robot does not drive past a place that can be blocked."""
    kind, what = fault["fault"], fault["what"]
    if kind == "blockage":
        place = robot.place_ahead()
        return place is not None and robot.inject("block_corridor", place, 0, fault["lasts"] or TRAP_LASTS)
    if kind == "localization":
        return robot.inject("kidnap", f"{robot.x:.2f} {robot.y:.2f} {robot.yaw + 2:.2f}")
    if kind == "program":
        how, node = what.split(" ", 1)
        return robot.inject("hang_node" if how == "hang" else "kill_node", node)
    if kind == "topic":
        return robot.inject("silence_topic" if what == "silent" else "slow_topic", "/scan", 0.3, TOPIC_LASTS)
    return None  # what the simulated robot cannot have


def live_under_ros(options, folder, faults):
    with Robot(options, folder) as robot:
        robot.connect(folder)
        wait_until(lambda: robot.distance > 2 and robot.level is not None, 300, "the robot does not leave its station")
        begun, level, wall = robot.now, robot.level, time.monotonic()
        left_out = break_and_wait(robot, options, sorted(faults, key=lambda fault: fault["seconds"]), begun)
        figures = {**{kind: robot.begun[kind] for kind in KINDS}, "requests": len(robot.requests),
                   "distance [km]": robot.distance / 1000, "energy [Ah]": (level - robot.level) * CAPACITY}
        return figures, left_out, (robot.now - begun) / (time.monotonic() - wall)


def break_and_wait(robot, options, due, begun):
    """Until the hours are over; what could not be broken."""
    left_out = []
    while robot.now - begun < options.hours * 3600:
        if robot.process.poll() is not None:
            raise RuntimeError("the robot has ended")
        while due and due[0]["seconds"] <= robot.now - begun:
            done = break_it(robot, due[0])
            if done is False:
                break
            fault = due.pop(0)
            if done is None:
                left_out.append(fault["fault"])
        time.sleep(0.3 / options.speed)
    return left_out + [fault["fault"] for fault in due]


# ---- both

def table(accelerated, ours, chance):
    lines = ["| | accelerated, same seed | accelerated, 20 seeds | under ROS | within |",
             "| --- | --- | --- | --- | --- |"]
    for name, value in ours.items():
        values = sorted(one[name] for one in chance)
        digits = 0 if isinstance(value, int) else 2
        is_in = values[0] <= value <= values[-1]
        least, most = (f"{bound:.{digits}f}" for bound in (values[0], values[-1]))
        lines.append(f"| {name} | {accelerated[name]:.{digits}f} | {least} – {most} | {value:.{digits}f} | "
                     f"{'yes' if is_in else 'no'} |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", type=pathlib.Path, default=SOURCE / "build/bin", help="folder of the programs")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("runs/bridge"))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--hours", type=float, default=2)
    parser.add_argument("--speed", type=float, default=3, help="times real time, of the robot under ROS")
    options = parser.parse_args()
    options.programs = options.programs.resolve()
    options.out.mkdir(parents=True, exist_ok=True)
    folder = pathlib.Path(tempfile.mkdtemp(prefix="run-", dir=options.out.resolve()))
    journals = live_accelerated(options, folder)
    start = journals[0]["span"][0]
    faults = [{**fault, "seconds": (fault["at"] - start) / 1e9} for fault in journals[0]["faults"]]
    figures, left_out, speed = live_under_ros(options, folder, faults)
    chance = [figures_of_journal(journal) for journal in journals]
    text = (f"Seed {options.seed}, {options.hours:g} h, {len(faults)} faults; the robot under ROS at {speed:.1f} times "
            f"real time, load of the computer {os.getloadavg()[1]:.1f} on {os.cpu_count()} processors.\n\n"
            f"{table(chance[0], figures, chance)}\n\nNot injected: {', '.join(left_out) or 'none'}.\n")
    (options.out / "bridge.md").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
