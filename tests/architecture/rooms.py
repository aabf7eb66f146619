#!/usr/bin/python3
"""The rooms of the house and their floors: the one table that floors_test.py holds the includes
against, and from which docs/pictures/rooms.svg and the table in docs/architecture.md are made.

    tests/architecture/rooms.py --write      after a change of the table
"""
import html
import pathlib
import sys

# Wing -> wings below it, of which a room may include everything.
WINGS = {
    "bt_core": (),
    "bt_nodes": ("bt_core",),
    "robot_app": ("bt_core", "bt_nodes"),
    "editor": ("bt_core",),
}

# Wing -> its floors from the ground up; floor -> room: what lives there. A room may include itself
# and rooms of lower floors. A folder inside a room belongs to it, unless it has a line of its own.
FLOORS = {
    "bt_core": [
        {"bt_core/base": "`Status`, `Diagnostic` (file:line:column, message, hint), `Outcome` and "
                         "`Expected`, `Clock` (wall, simulated), `WakeUp`"},
        {"bt_core/data": "`Value` of any registered type, typed ports as members, the blackboard's "
                         "`Layout` and slots, the `Inbox`"},
        {"bt_core/script": "the expression language of guards, hooks and script nodes, compiled to "
                           "typed code on slots"},
        {"bt_core/model": "`Document` (the user's text with an index of positions), `Edit` (a change "
                          "of it that can be undone), `SourceText` (the text, packed, for a "
                          "program), `Project` (files with includes), format 3, `Manifest` and "
                          "`NodeModel`, what counts as a key ([XML](xml.md))"},
        {"bt_core/nodes": "what control nodes and decorators do in a tick; base classes of the "
                          "user's nodes"},
        {"bt_core/engine": "`Registry`, `Compile` (Document → `Program`; [loading](loading.md)), "
                           "`Executor`, the events of a tick and their stream, the run loop"},
        {"bt_core/frames": "the events of a run as compact, checksummed frames: what records consist "
                           "of and what the live socket sends",
         "bt_core/testing": "the harness for testing one leaf; scenarios for whole trees "
                            "([testing](testing.md))"},
        {"bt_core/live": "the live socket: Groot2 protocol and more, breakpoints, client, the page "
                         "([live](live.md))",
         "bt_core/record": "the recorder and the reader of its files ([format](record_format.md))"},
        {"bt_core/analysis": "what can be asked of a record: why, the same run again, statistics, "
                             "other formats ([replay](replay.md))"},
        {"bt_core/compat": "the interface of BehaviorTree.CPP on this engine "
                           "([migration](migration.md))"},
    ],
    "bt_nodes": [
        {"bt_nodes/basics": "`Wait`, `IsTrue`; the base of leaves that call a capability",
         "bt_nodes/power": "the state of the battery and what is decided by it",
         "bt_nodes/application": "starting and stopping the tree of the application"},
        {"bt_nodes/navigation": "`Navigator`, waypoints, `Routes`",
         "bt_nodes/docking": "`ChargingStation`",
         "bt_nodes/interaction": "speaking, and how the robot looks",
         "bt_nodes/processes": "`ProcessManager`: programs of the robot"},
        {"bt_nodes/people": "who is around, and leaves that look at them",
         "bt_nodes/monitoring": "the report of the monitors in a tree"},
        {"bt_nodes/operators": "`SupervisorChannel`: asking people for help",
         "bt_nodes/visitors": "what visitors want, and what is said to them",
         "bt_nodes/recovery": "repairs, their budgets and their verdicts"},
        {"bt_nodes": "all leaves in a `Registry`"},
    ],
    "robot_app": [
        {"robot_app/common": "what several capabilities share: poses, grids, scans, pictures, "
                             "the [places](places.md) of a site, "
                             "YAML fields, the robot's description, nodes of ROS"},
        {"robot_app/simulation": "the simulated floor and robot with all sensors and faults, and "
                                 "their ROS nodes ([robot](robot.md))",
         "robot_app/localization": "odometry filter (EKF) and Monte Carlo localization "
                                   "([localization](localization.md))",
         "robot_app/mapping": "making a map while a person drives, maps in files, the map server "
                              "([localization](localization.md#making-a-map))",
         "robot_app/slam": "maps in three dimensions over many sessions: pose graph, places in "
                           "pictures and clouds, voxels ([maps](slam.md))",
         "robot_app/navigation": "planner, follower; the action servers `move_base` and "
                                 "`motion`",
         "robot_app/perception": "people: in the clouds of the 3-D lidar, over time, on `/people` "
                                 "([perception](perception.md))",
         "robot_app/docking": "the way into the station; the action server `docking`",
         "robot_app/processes": "the process supervisor, the only one that starts and restarts "
                                "programs ([supervision](supervision.md))",
         "robot_app/monitoring": "the monitors of nodes, topics, computers, power, localization, "
                                 "navigation; the aggregator ([monitoring](monitoring.md))",
         "robot_app/teleoperation": "the velocity mux: who drives",
         "robot_app/assistance": "human supervisors: requests, messages, their web page "
                                 "([supervisors](supervisors.md))",
         "robot_app/knowledge": "what the robot knows of its site, and what people ask of it: "
                                "imports, queries, understanding, answers "
                                "([service](service.md))",
         "robot_app/expression": "how it looks: face, lights, ears and arms, as data and as "
                                 "simulated devices ([service](service.md#how-it-looks))",
         "robot_app/questionnaire": "what people think of it, asked and counted "
                                    "([service](service.md#asking-people))",
         "robot_app/tablet": "the page of the tablet in its chest "
                             "([service](service.md#the-tablet))",
         "robot_app/storage": "messages on their way to a database elsewhere: documents, the spool, "
                              "the servers ([storage](storage.md))",
         "robot_app/metrics": "figures of trees and robot for Prometheus ([fleet](fleet.md))"},
        {"robot_app/speech": "mouth and ear: text to speech, speech to text, the action `/speak`, "
                             "who is heard and answered ([service](service.md))",
         "robot_app/training": "`coppice-train`: what the robot's classifiers learn from, and how "
                               "well they have learnt it",
         "robot_app/deployment": "sixteen days of the robot in one process under simulated time, "
                                 "and their report",
         "robot_app/ros": "the interfaces of `bt_nodes` implemented on ROS; feeds from topics to "
                          "blackboards"},
    ],
    "editor": [
        {"editor/keys": "keys and mouse as a queue, chords, the table of commands, fuzzy search",
         "editor/render": "pictures, and triangles to pixels without a display",
         "editor/files": "open files: text and undo, copies of unsaved work, merging, what git has "
                        "of them",
         "editor/scene": "a tree written out as a flat scene; the uses of its keys, its notes",
         "editor/timeline": "a run in memory: time, lanes, figures of a key"},
        {"editor/theme": "colours, fonts, geometry, the `Ui` that all draw with",
         "editor/window": "a window of GLFW and its OpenGL",
         "editor/document": "changes of trees: drafts, subtrees, keys, search, fixes",
         "editor/diff": "what became of a node from one version of a tree to another",
         "editor/live": "runs of robots, records and simulations as the editor follows them"},
        {"editor/simulation": "a tree without a robot: scripts for its leaves, chance, scenarios",
         "editor/canvas/layout": "where the boxes of a tree go"},
        {"editor/canvas/paint": "how a node, a line and a mark are painted"},
        {"editor/canvas": "a tree on the screen, and the mouse on it"},
        {"editor/export": "pictures of trees and their differences in files"},
        {"editor/workspace": "what is open, what is shown, what the user is doing"},
        {"editor/commands": "what keys, menus and the palette can run",
         "editor/settings": "what is found again the next time, of the user and of each project"},
        {"editor/panels": "the tiles and bars around the canvas, popups"},
        {"editor/shell": "the editor as a function of events, without a window"},
    ],
}

# On the roof of its wing: wires things and runs; nobody includes it.
PROGRAMS = {
    "bt_core/cli": "`coppice cat, check, convert, live, migrate, nodes, record, replay, run, stats, test, "
                   "trace, upgrade`; `diff` and `export` are programs of the editor",
    "bt_core/python": "`import coppice`: leaves, trees, tests and records in Python ([manual](python.md))",
    "robot_app/app": "`coppice-robot` (runs the trees) and `coppice-demo`",
    "editor/app": "`coppice-edit`, `coppice-diff`, `coppice-export`",
    "editor/web": "the editor as a web page",
}

# Arrows beside the floors, each with its reason.
ARROWS = {
    ("robot_app/mapping", "robot_app/localization"): "a map is made with the same scan matching",
    ("robot_app/slam", "robot_app/localization"): "odometry of the last seconds",
    ("robot_app/slam", "robot_app/mapping"): "grids as messages",
    ("robot_app/slam", "robot_app/perception"): "the same clouds and pictures come as messages",
    ("robot_app/assistance", "robot_app/teleoperation"): "the page drives",
    ("robot_app/tablet", "robot_app/knowledge"): "what is pressed is answered from it",
}

# Rooms whose inner folders still include each other in a circle.
INNER_CIRCLES = (
    "bt_core/cli", "bt_core/engine", "bt_core/live",
    "robot_app/assistance", "robot_app/monitoring", "robot_app/processes")

# Folders of headers of others, and where they may be included. For bt_core, whose headers are read
# by all, its headers are a case of their own: everything heavy stays in .cc files, but for headers
# that only their own room includes.
ROS = (r"(ros|actionlib\w*|tf2\w*|\w+_msgs|\w+_srvs|xmlrpcpp|rosbag\w*|diagnostic_\w+)/")
FOREIGN = {  # name: (pattern, where at all, where in headers)
    "ROS": (ROS, ("robot_app",), ("robot_app",)),
    "OpenCV and PCL": (r"(opencv2|pcl\w*|cv_bridge)/", ("robot_app",), ("robot_app",)),
    "Dear ImGui and GLFW": (r"(imgui|GLFW/|backends/imgui)", ("editor",), ("editor",)),
    "JSON": (r"nlohmann/json\.hpp", ("bt_core", "editor/live", "robot_app"), ("bt_core/compat",)),
    "pybind11": (r"pybind11/", ("bt_core/python",), ("bt_core/python",)),
    "ZeroMQ": (r"zmq\.", (), ()),
    "Boost": (r"boost/", ("bt_core/live", "robot_app"), (
        "bt_core/live/discovery", "bt_core/live/web", "robot_app")),
    "tinyxml2": (r"tinyxml2", ("bt_core/model", "robot_app/common/robot_description.cc"), ()),
}

ROOT = pathlib.Path(__file__).resolve().parents[2]
PICTURE = ROOT / "docs/pictures/rooms.svg"
PAGE = ROOT / "docs/architecture.md"
BEGIN, END = "<!-- rooms: tests/architecture/rooms.py --write -->\n", "<!-- end of rooms -->\n"


def floor_of_rooms():
    """Room -> its floor in its wing."""
    roof = {room: len(FLOORS[room.split("/")[0]]) for room in PROGRAMS}
    return {**roof, **{room: number for floors in FLOORS.values()
                       for number, floor in enumerate(floors) for room in floor}}


def room_of(path, rooms):
    """The room that a file or folder lies in, or None."""
    while path and path not in rooms:
        path = path.rpartition("/")[0]
    return path or None


def table():
    lines = ["| room | what lives there |", "|---|---|"]
    for wing, floors in FLOORS.items():
        roof = {room: what for room, what in PROGRAMS.items() if room.startswith(wing + "/")}
        lines += [f"| `{room}` | {what} |" for floor in floors + [roof]
                  for room, what in floor.items()]
    return "\n".join(lines + ["| `trees` | `application`, `behavior`, `monitor`, `recovery`; each "
                              "file can be checked and run alone |", ""])


def page(text):
    """The text of docs/architecture.md with the table as it should be."""
    before, rest = text.split(BEGIN)
    return before + BEGIN + table() + END + rest.split(END)[1]


WIDTH, ROW, GAP, LEFT, MOST = 960, 30, 6, 14, 5
COLORS = {"bt_core": "#8a5a2a", "bt_nodes": "#3c7a3c", "robot_app": "#22696b", "editor": "#2b5797"}


def picture():
    """bt_core below; on it the robot and, beside it, the editor, which do not know each other."""
    whole = WIDTH - 2 * LEFT
    half = (whole - GAP) / 2
    core = rows(FLOORS["bt_core"])
    robot = rows(FLOORS["bt_nodes"] + FLOORS["robot_app"])
    editor = rows(FLOORS["editor"])
    height = ROW + GAP
    roof = LEFT + 24
    ground = roof + (1 + max(len(robot), len(editor))) * height
    shapes = row(list(PROGRAMS), LEFT, roof, whole)
    for names, left, width, bottom in ((core, LEFT, whole, ground + len(core) * height),
                                       (robot, LEFT, half, ground),
                                       (editor, LEFT + half + GAP, half, ground)):
        for number, floor in enumerate(names):
            shapes += row(floor, left, bottom - (number + 1) * height, width)
    bottom = ground + len(core) * height + LEFT
    title = "A room includes rooms below it, never one beside it, but for the arrows that are named"
    return "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{bottom}" '
        'font-family="DejaVu Sans, sans-serif" font-size="12">',
        '<rect width="100%" height="100%" fill="#1c1f26"/>',
        f'<text x="{LEFT}" y="24" fill="#c9d1d9">{title}</text>'] + shapes + ["</svg>", ""])


def rows(floors):
    """The rooms of the floors from the ground up; a full floor takes more than one row."""
    split = []
    for floor in map(list, floors):
        count = -(-len(floor) // MOST)
        size = -(-len(floor) // count)
        split += [floor[i:i + size] for i in range(0, len(floor), size)]
    return split


def row(floor, left, y, width):
    """The boxes of these rooms, as wide as their names need."""
    names = [short_name(room, len(floor)) for room in floor]
    room_for_names = width - GAP * (len(names) - 1)
    total = sum(len(name) + 3 for name in names)
    shapes = []
    for room, name in zip(floor, names):
        part = room_for_names * (len(name) + 3) / total
        size = min(12, 1.6 * part / max(len(name), 1))
        color = COLORS[room.split("/")[0]]
        shapes.append(f'<rect x="{left:.0f}" y="{y}" width="{part:.0f}" height="{ROW}" rx="5" '
                      f'fill="{color}"/>')
        shapes.append(f'<text x="{left + part / 2:.0f}" y="{y + 20}" fill="#fff" '
                      f'text-anchor="middle" font-size="{size:.1f}">{html.escape(name)}</text>')
        left += part + GAP
    return shapes


def short_name(room, neighbours):
    """Without its wing where the floor is full."""
    is_crowded = neighbours >= 4 and room not in PROGRAMS
    return room.partition("/")[2] if is_crowded else room


def write():
    PICTURE.write_text(picture())
    PAGE.write_text(page(PAGE.read_text()))


if __name__ == "__main__":
    if sys.argv[1:] != ["--write"]:
        sys.exit(__doc__)
    write()
