"""Gives the programs of Coppice the files of an attacker: records, trees, scenarios, and places to
write to. Each must end with a message, soon, and without taking the memory of the computer.

usage: file_attack.py COPPICE MIB EDITOR ROBOT
MIB: how much memory no program may ever take. EDITOR, ROBOT: ON or OFF, whether there is one.
"""
import json
import os
import re
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import unittest
import zipfile

PATIENCE = 30  # s, for a program
SAMPLE = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                      "../../robot_app/knowledge/sample")
TREE = ('<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence><Script code="n := 1"/>'
        "%s</Sequence></BehaviorTree></root>")


class Ended:
    """What came of a program."""

    def __init__(self, command, folder, stack=None):
        def limit():
            if stack:
                resource.setrlimit(resource.RLIMIT_STACK, (stack, stack))

        with tempfile.TemporaryFile() as out:
            process = subprocess.Popen([PROGRAM] + command, cwd=folder, stdin=subprocess.DEVNULL,
                                       stdout=out, stderr=subprocess.STDOUT, preexec_fn=limit)
            late = threading.Event()
            timer = threading.Timer(PATIENCE, lambda: (late.set(), process.kill()))
            timer.start()
            _, status, usage = os.wait4(process.pid, 0)
            timer.cancel()
            self.is_late = late.is_set()
            process.returncode = self.code = (-os.WTERMSIG(status) if os.WIFSIGNALED(status)
                                              else os.WEXITSTATUS(status))
            self.memory = usage.ru_maxrss << 10
            out.seek(0)
            self.text = out.read(1 << 20).decode(errors="replace")


def crc32c(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc = CRC_TABLE[(crc ^ byte) & 0xFF] ^ crc >> 8
    return crc ^ 0xFFFFFFFF


def make_crc_table():
    table = []
    for value in range(256):
        for _ in range(8):
            value = value >> 1 ^ (0x82F63B78 if value & 1 else 0)
        table.append(value)
    return table


CRC_TABLE = make_crc_table()
TREE_FRAME, STATE_FRAME, EVENTS_FRAME = 1, 2, 3


def frame(kind, payload):
    head = struct.pack("<IB", len(payload), kind)
    return head + struct.pack("<I", crc32c(head + payload)) + payload


def frames_of(record):
    """Offset, type, and end of each."""
    at = 12
    while at + 9 <= len(record):
        size, kind = struct.unpack_from("<IB", record, at)
        yield at, kind, at + 9 + size
        at += 9 + size


def zeros(size, starts_stream):
    """So many zero bytes, packed with zstd in 4 bytes for each 128 KiB."""
    head = b"\x28\xb5\x2f\xfd\x00\x50" if starts_stream else b""
    block = 128 << 10
    return head + struct.pack("<I", 1 << 1 | block << 3)[:3].ljust(4, b"\0") * (size // block)


def raw_block(content):
    """Of zstd, as it is."""
    return struct.pack("<I", len(content) << 3)[:3] + content


def varint(number):
    text = b""
    while number > 127:
        text += bytes([number & 127 | 128])
        number >>= 7
    return text + bytes([number])


class FileAttack(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return name

    def run_program(self, *command, codes=(0, 1, 2), stack=None):
        ended = Ended(list(command), self.folder, stack)
        what = " ".join(command) + ": " + ended.text[-500:]
        self.assertFalse(ended.is_late, what)
        self.assertIn(ended.code, codes, what)
        self.assertLessEqual(ended.memory, MEMORY, what)
        return ended.text


class Records(FileAttack):
    def setUp(self):
        super().setUp()
        self.write("t.xml", TREE % '<Sleep msec="1"/>')
        self.run_program("run", "t.xml", "--quiet", "--record", "good.coppice", codes=(0,))
        with open(self.path("good.coppice"), "rb") as file:
            self.good = file.read()

    def read(self, record, codes=(0, 1, 2)):
        self.write("bad.coppice", record)
        texts = [self.run_program("stats", "bad.coppice", codes=codes),
                 self.run_program("replay", "bad.coppice", "--print", codes=codes),
                 self.run_program("convert", "bad.coppice", "out%d.json" % len(os.listdir(
                     self.folder)), codes=codes)]
        return texts[0]

    def after(self, kind):
        return next(end for _, found, end in frames_of(self.good) if found == kind)

    def test_ticks_that_unpack_to_gigabytes_are_damaged(self):
        bomb = frame(EVENTS_FRAME, zeros(64 << 20, False))
        self.assertLess(len(bomb), 5000)
        self.assertIn("damaged", self.read(self.good[:self.after(STATE_FRAME)] + bomb * 20))

    def test_ticks_without_end_take_the_memory_that_they_may_take(self):
        full = frame(EVENTS_FRAME, zeros(1 << 20, False))  # 262 144 ticks in which nothing happens
        record = self.write("long.coppice", self.good[:self.after(STATE_FRAME)] + full * 40)
        self.assertLess(os.path.getsize(self.path(record)), 8000)
        for command in (["stats", record], ["replay", record, "--print"],
                        ["convert", record, "out.json"]):
            self.assertIn("more than 129 MiB of memory", self.run_program(*command, codes=(2,)))
            text = self.run_program(*command, "--memory", "64", codes=(2,))
            self.assertIn("more than 64 MiB of memory", text)

    def test_a_tree_that_unpacks_to_gigabytes_is_damaged(self):
        bomb = frame(TREE_FRAME, zeros(1 << 30, True))
        self.read(self.good[:12] + bomb)
        self.assertIn("damaged", self.read(self.good + bomb))

    def test_a_tree_of_millions_of_nodes_or_slots_is_damaged(self):
        millions = 9_000_000
        no_nodes = b"\1" + bytes(6)  # but the root
        for lists, size in ((varint(millions), 7), (no_nodes + varint(15_000_000), 4)):
            # A run without names, one document, no models.
            head = bytes(1 + 16 + 4 + 1) + b"\1" + bytes(3) + lists
            count = millions if size == 7 else 15_000_000
            tree = raw_block(head) + zeros(size * count, False) + raw_block(
                bytes(size * count % (128 << 10) + (1 if size == 7 else 0)))
            bomb = frame(TREE_FRAME, b"\x28\xb5\x2f\xfd\x00\x50" + tree)
            self.assertIn("tree", self.read(self.good[:12] + bomb, codes=(1, 2)))

    def test_damaged_records_end_with_a_message(self):
        for at in range(0, len(self.good), max(1, len(self.good) // 8)):
            damaged = bytearray(self.good)
            damaged[at] ^= 0x55
            self.read(bytes(damaged))
            self.read(self.good[:at])

    def test_lengths_that_lie_are_damaged(self):
        head = struct.pack("<IB", 0xFFFFFFFF, EVENTS_FRAME)
        self.read(self.good + head + struct.pack("<I", crc32c(head)))

    def test_who_is_killed_on_an_overloaded_computer_has_recorded_all_but_the_last_second(self):
        self.write("loop.xml", TREE % '<Repeat num_cycles="-1"><Sleep msec="10"/></Repeat>')
        others = [subprocess.Popen(["/bin/sh", "-c", "while :; do :; done"])
                  for _ in range(4 * os.cpu_count())]
        try:
            run = subprocess.Popen([PROGRAM, "run", "loop.xml", "--record", "killed.coppice"],
                                   cwd=self.folder, stdout=subprocess.PIPE, text=True)
            printed = ""
            while self.last_tick(printed) < 150:
                line = run.stdout.readline()
                self.assertTrue(line, "it runs")
                printed = line
            run.kill()
            last = self.last_tick(printed + run.stdout.read())
            run.wait()
            run.stdout.close()
        finally:
            for other in others:
                other.kill()
                other.wait()
        recorded = self.last_tick(self.run_program("replay", "killed.coppice", "--print"))
        self.assertGreater(recorded, last - 100)

    @staticmethod
    def last_tick(printed):
        return max([int(tick) for tick in re.findall(r"\btick (\d+)", printed)], default=0)

    def test_what_is_no_file_is_no_record(self):
        os.mkfifo(self.path("pipe"))
        for name in ("/dev/zero", "/dev/full", "pipe", "."):
            self.run_program("stats", name, codes=(2,))


class Trees(FileAttack):
    def check(self, text, stack=None):
        self.write("t.xml", text)
        return self.run_program("check", "t.xml", stack=stack)

    def test_entities_do_not_multiply(self):
        entities = '<!ENTITY a0 "ha">' + "".join(
            '<!ENTITY a%d "%s">' % (i, "&a%d;" % (i - 1) * 10) for i in range(1, 20))
        self.check("<!DOCTYPE r [" + entities + ']><root name="&a19;"/>')

    def test_nesting_ends_with_an_error(self):
        deep = TREE % ("<Inverter>" * 100000 + "</Inverter>" * 100000)
        self.assertIn("error", self.check(deep, stack=512 << 10))

    def test_attributes_without_end_are_an_error(self):
        many = "".join(' a%d="1"' % i for i in range(100000))
        self.assertIn("t.xml:1:", self.check(TREE % ("<Sleep%s/>" % many)))

    def test_elements_texts_and_lines_without_end_are_too_large(self):
        for filling in ("<a/>" * 1_500_000, "<!---->x" * 1_200_000, "\n" * 30_000_000,
                        '<a b=""/>' * 800_000):
            self.assertIn("too large", self.check('<root BTCPP_format="4">' + filling + "</root>"))

    def test_very_many_attributes_in_many_elements_are_an_error(self):
        wrong = "".join(' a%d="1"' % i for i in range(9900))
        self.assertIn("more than 1000 attributes", self.check(TREE % (("<Sleep%s/>" % wrong) * 40)))

    def test_many_trees_in_a_large_file_are_checked_in_one_go(self):
        trees = "".join('<BehaviorTree ID="T%d"><AlwaysSuccess/></BehaviorTree>' % i
                        for i in range(500))
        self.check('<root BTCPP_format="4" main_tree_to_execute="T0"><!--' + "x\n" * 4000000
                   + "-->" + trees + "</root>")

    def test_missing_trees_are_looked_for_once_in_large_files_beside(self):
        for i in range(10):
            self.write("beside%d.xml" % i, TREE % ('<AlwaysSuccess name="Lost"/>' * 130000))
        text = self.check(TREE % ("<Sequence>" + "".join(
            '<SubTree ID="Lost" name="%d"/>' % i for i in range(40)) + "</Sequence>"))
        self.assertIn('"Lost"', text)

    def test_includes_without_end_are_an_error(self):
        for i in range(3000):
            self.write("%d.xml" % i, '<root BTCPP_format="4"><include path="%d.xml"/></root>'
                       % (i + 1))
        text = self.run_program("check", "0.xml", codes=(1, 2), stack=512 << 10)
        self.assertIn("deep", text)

    def test_many_includes_are_read(self):
        names = "".join('<include path="%d.xml"/>' % i for i in range(3000))
        for i in range(3000):
            self.write("%d.xml" % i, '<root BTCPP_format="4"/>')
        self.check('<root BTCPP_format="4">' + names + "</root>")

    def test_packages_that_there_are_not_are_not_looked_for_without_end(self):
        self.check('<root BTCPP_format="4">' + "".join(
            '<include ros_pkg="pkg%d" path="a.xml"/>' % i for i in range(3000)) + "</root>")

    def test_devices_and_pipes_are_no_trees(self):
        os.mkfifo(self.path("pipe"))
        for name in ("/dev/zero", "/dev/full", "pipe", "/proc/kmsg", "."):
            for command in (["check", name], ["run", name, "--quiet"], ["upgrade", name]):
                self.run_program(*command, codes=(1, 2))
            self.check('<root BTCPP_format="4"><include path="%s"/></root>' % name)

    def test_subtrees_do_not_multiply(self):
        trees = "".join('<BehaviorTree ID="T%d"><Sequence><SubTree ID="T%d"/><SubTree ID="T%d"/>'
                        "</Sequence></BehaviorTree>" % (i, i + 1, i + 1) for i in range(30))
        self.check('<root BTCPP_format="4" main_tree_to_execute="T0">' + trees +
                   '<BehaviorTree ID="T30"><AlwaysSuccess/></BehaviorTree></root>')

    def test_subtrees_do_not_multiply_keys_and_scripts(self):
        call = '<BehaviorTree ID="Main"><Sequence>' + '<SubTree ID="T"/>' * 450
        for body in ('<Script code="k%d := 1; b := k%d + 1"/>',
                     '<SetBlackboard value="%d" output_key="k%d"/>'):
            self.assertIn("more than 128 MiB", self.check(
                '<root BTCPP_format="4" main_tree_to_execute="Main">' + call +
                '</Sequence></BehaviorTree><BehaviorTree ID="T"><Sequence>' +
                "".join(body % (i, i) for i in range(2200)) +
                "</Sequence></BehaviorTree></root>"))

    def test_a_long_path_is_not_given_to_thousands_of_nodes(self):
        name = "n" * 1_000_000
        self.write("t.xml", '<root BTCPP_format="4" main_tree_to_execute="M"><BehaviorTree ID="M">'
                   '<SubTree ID="T" name="%s"/></BehaviorTree><BehaviorTree ID="T"><Sequence>%s'
                   "</Sequence></BehaviorTree></root>" % (name, "<AlwaysSuccess/>" * 5000))
        for command in (["check", "t.xml"], ["run", "t.xml", "--quiet", "--record", "r.coppice"],
                        ["test", "--random", "2", "t.xml"]):
            self.assertIn("long paths of the nodes", self.run_program(*command, codes=(1, 2)))

    def test_very_many_unknown_names_are_said_soon(self):
        trees = "".join('<BehaviorTree ID="T%d"><SubTree ID="U%d"/></BehaviorTree>' % (i, i)
                        for i in range(50_000))
        uses = "<Act %s/>" % " ".join('pxrt%05d="1"' % i for i in range(900))
        ports = "".join('<input_port name="port%05d"/>' % i for i in range(110_000))
        names = ["%d" % i + "n" * 900 for i in range(1900)]
        for text in (trees,
                     '<BehaviorTree ID="T0"><Sequence>' + uses * 200 + "</Sequence></BehaviorTree>"
                     '<TreeNodesModel><Action ID="Act">' + ports + "</Action></TreeNodesModel>",
                     "".join('<BehaviorTree ID="T%s"><SubTree ID="%s"/></BehaviorTree>' % (name, name)
                             for name in names)):
            self.check('<root BTCPP_format="4">' + text + "</root>")

    def test_a_text_that_joins_itself_fails_at_its_node(self):
        self.write("t.xml", TREE % '<Script code="s := 0.5 .. 1"/><Repeat num_cycles="100">'
                                   '<Script code="s := s .. s"/></Repeat>')
        self.assertIn("scripts join texts up to", self.run_program("run", "t.xml", codes=(1,)))

    def test_long_scripts_end_with_an_error(self):
        for script in ("(" * 30000, "1+" * 30000 + "1", "-" * 60000 + "1", "x" * 1000000):
            self.assertIn("error", self.check(TREE % ('<Script code="%s"/>' % script)))


class Names(FileAttack):
    """What somebody calls a node, or a scenario, says nothing to the terminal."""

    def test_a_terminal_is_told_nothing_by_names(self):
        name = "\x1b[2Jgone"
        self.write("t.xml", TREE % '<AlwaysSuccess name="&#27;[2Jgone"/>')
        texts = [self.run_program("run", "t.xml", "--record", "r.coppice", codes=(0,)),
                 self.run_program("check", "t.xml"), self.run_program("stats", "r.coppice")]
        for option in ("--print", "--verify", "--tick=1", "--why=" + name):
            texts.append(self.run_program("replay", "r.coppice", option, codes=(0,)))
        self.write("s.json", json.dumps({"tree": "t.xml", "scenarios": [
            {"name": name, "steps": [{"expect": {"status": "FAILURE"}}]}]}))
        texts += [self.run_program("test", "s.json", codes=(1,)),
                  self.run_program("test", "--random", "2", "t.xml", codes=(0,))]
        for text in texts:
            self.assertNotIn("\x1b", text)
        self.assertIn("\\x1B[2Jgone", texts[0])


class Scenarios(FileAttack):
    def test_scenarios_of_all_kinds_end_with_a_message(self):
        self.write("t.xml", TREE % '<Sleep msec="1"/>')
        for name, text in (("deep", "[" * 1000000), ("object", '{"a":' * 100000),
                           ("number", '{"scenarios": 1e999}'), ("bytes", "\xff\0\1")):
            self.write(name + ".json", text)
            self.run_program("test", name + ".json", codes=(1, 2))

    def test_very_many_values_in_one_line_are_refused_soon(self):
        for name, text in (("lists", "[" + "[]," * 1_000_000 + "[]]"),
                           ("longer", "[" + "[]," * 6_000_000 + "[]]"),
                           ("names", "{" + ",".join('"%d":1' % i for i in range(500_000)) + "}")):
            self.write(name + ".json", text)
            self.assertIn(name + ".json", self.run_program("test", name + ".json", codes=(2,)))

    def test_devices_are_no_scenarios(self):
        for name in ("/dev/zero", "/dev/full", "."):
            self.run_program("test", name, codes=(1, 2))


class Places(FileAttack):
    """`-o` and its like replace nothing but files."""

    def setUp(self):
        super().setUp()
        self.write("old.xml", '<root main_tree_to_execute="A"><BehaviorTree ID="A">'
                              "<AlwaysSuccess/></BehaviorTree></root>")

    def test_a_pipe_stays_a_pipe(self):
        os.mkfifo(self.path("pipe"))
        self.run_program("upgrade", "old.xml", "-o", "pipe", codes=(2,))
        self.assertTrue(os.path.exists(self.path("pipe")) and not os.path.isfile(
            self.path("pipe")))

    def test_links_in_a_circle_and_names_without_end_are_no_files(self):
        self.run_program("run", self.write("t.xml", TREE % ""), "--record", "r.coppice", "--quiet")
        os.symlink("circle", self.path("circle"))
        for name in ("circle", "a" * 5000):
            self.run_program("migrate", name, codes=(2,))
            self.run_program("replay", "r.coppice", "--scenario", "out.test.json", "--tree-file",
                             name, codes=(2,))
            self.run_program("replay", "r.coppice", "--scenario", name)

    def test_a_link_to_a_device_stays_a_link(self):
        os.symlink("/dev/full", self.path("link"))
        self.run_program("upgrade", "old.xml", "-o", "link", codes=(2,))
        self.assertEqual(os.readlink(self.path("link")), "/dev/full")

    def test_a_record_overwrites_nothing(self):
        self.write("t.xml", TREE % "")
        self.run_program("run", "t.xml", "--record", "old.xml", codes=(2,))
        with open(self.path("old.xml")) as file:
            self.assertIn("AlwaysSuccess", file.read())


class Site(FileAttack):
    """What others publish, and `coppice knowledge import` reads beside a robot that drives."""

    def setUp(self):
        super().setUp()
        shutil.copytree(SAMPLE, self.path("site"))
        self.feed = self.path("site/transport/erlenhof.zip")

    def refuse(self, expected, *options):
        self.assertIn(expected, self.run_program("knowledge", "import", "site", "db", *options,
                                                 codes=(1,)))

    def change_feed(self, table, rows):
        with zipfile.ZipFile(self.feed) as feed:
            tables = {name: feed.read(name) for name in feed.namelist()}
        tables[table] = rows
        with zipfile.ZipFile(self.feed, "w", zipfile.ZIP_DEFLATED) as feed:
            for name, content in tables.items():
                feed.writestr(name, content)

    def test_staff_without_end_is_refused(self):
        self.write("site/staff.csv", "given_name,family_name\n" + "".join(
            "a%d,b\n" % i for i in range(400_000)))
        self.refuse("more than there is memory for")

    def test_a_device_is_no_list_of_staff(self):
        os.remove(self.path("site/staff.csv"))
        os.symlink("/dev/zero", self.path("site/staff.csv"))
        self.refuse("staff.csv: error: is longer than")

    def test_a_menu_of_very_many_meals_in_one_line_is_refused_soon(self):
        self.write("site/menus/canteen.en.json", "[" + '{"date":"2026-11-23","meals":[]},' *
                   400_000 + "{}]")
        self.refuse("more than 400000 values")

    def test_stops_that_unpack_to_gigabytes_are_refused(self):
        self.change_feed("stops.txt", "stop_id,stop_name\n" + "".join(
            "%d,\n" % i for i in range(400_000)))
        self.refuse("more than there is memory for", "--memory", "32")

    def test_a_bus_that_comes_every_second_for_days_is_refused(self):
        self.change_feed("frequencies.txt", "trip_id,start_time,end_time,headway_secs\n" +
                         "4-weekday-0000,00:00:00,96:00:00,1\n" * 1000)
        self.refuse("more than there is memory for", "--memory", "32")

    def test_aliases_do_not_multiply_places(self):
        self.write("site/places.yaml", "site: x\nplaces:\n - &p {name: a, x: 1, y: 1, categories: ["
                   + "c," * 100_000 + "c]}\n" + " - *p\n" * 100_000)
        self.refuse("too large with its aliases")

    def test_very_many_values_of_places_are_refused(self):
        self.write("site/places.yaml", "places: [" + "[]," * 300_000 + "[]]\n")
        self.refuse("more than 131072 values")

    def test_a_place_within_itself_is_refused(self):
        self.write("site/places.yaml", "places: &a [*a]\n")
        self.refuse("too large with its aliases")


class Editor(FileAttack):
    """What is opened in the editor, and what that includes, may be no file at all."""

    def test_hundreds_of_thousands_of_attributes_are_shown_soon(self):
        attributes = "".join(' a%d="1"' % i for i in range(900))
        self.write("a.xml", TREE % (("<Sleep%s/>" % attributes) * 300))
        begin = self.calculated()
        self.edit("a.xml", codes=(0, 1, 2))
        self.assertLess(self.calculated() - begin, 10)

    @staticmethod
    def calculated():
        """By programs that have ended [s]: a busy computer takes longer, but not more of it."""
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime

    def edit(self, name, codes=(1, 2)):
        return self.run_program("edit", name, "--headless", codes=codes)

    def test_what_each_instance_of_a_tree_takes_along_does_not_multiply(self):
        calls = "<Sequence>%s</Sequence>" % ('<SubTree ID="T"/>' * 3000)
        for name, comment, value in (("n" * 1_000_000, "", "1"), ("n", "c" * 1_000_000, "1"),
                                     ("n", "", "v" * 1_000_000)):
            self.write("m.xml", '<root BTCPP_format="4" main_tree_to_execute="M"><BehaviorTree '
                       'ID="M"><SubTree ID="S" name="%s"/></BehaviorTree><BehaviorTree ID="S">%s'
                       '</BehaviorTree><BehaviorTree ID="T"><!--%s--><AlwaysSuccess name="%s"/>'
                       "</BehaviorTree></root>" % (name, calls, comment, value))
            self.edit("m.xml", codes=(0, 1, 2))
            self.run_program("export", "m.xml", "-o", "m.svg", codes=(0, 1, 2))

    def test_very_many_comments_are_read_soon(self):
        self.write("c.xml", TREE % ("<!--a-->" * 500_000 + "<AlwaysSuccess/>"))
        self.edit("c.xml", codes=(0, 1, 2))

    def test_devices_are_neither_trees_nor_records(self):
        for number, device in enumerate(("/dev/zero", "/dev/full")):
            for ending in (".xml", ".btlog", ".coppice"):
                os.symlink(device, self.path("z%d%s" % (number, ending)))
                self.edit("z%d%s" % (number, ending))

    def test_a_pipe_is_not_waited_for(self):
        for name in ("p.xml", "p.btlog", "p.coppice"):
            os.mkfifo(self.path(name))
            self.edit(name, codes=(0, 1, 2))

    def test_long_scripts_and_wide_trees_are_opened_soon(self):
        for content in ('<Script code="%s"/>' % ("x := 1 &lt; 2;" * 100_000),
                        "<Sequence>%s</Sequence>" % ("<AlwaysSuccess/>" * 100_000),
                        "<Sequence>%s</Sequence>" % "".join(
                            '<Script code="k%d:=1"/>' % i for i in range(60_000))):
            self.write("w.xml", TREE % content)
            self.edit("w.xml", codes=(0, 1, 2))

    def test_lines_without_end_take_little(self):
        self.write("l.xml", '<root BTCPP_format="4">' + "\n" * 20_000_000 + "</root>")
        self.edit("l.xml", codes=(0, 1, 2))

    def test_includes_may_be_devices_and_pipes(self):
        os.mkfifo(self.path("pipe.xml"))
        for place in ("/dev/zero", "/proc/kmsg", "pipe.xml", "."):
            self.write("i.xml", '<root BTCPP_format="4"><include path="%s"/><BehaviorTree ID="A">'
                       "<AlwaysSuccess/></BehaviorTree></root>" % place)
            self.edit("i.xml", codes=(0, 1, 2))


if __name__ == "__main__":
    PROGRAM = os.path.abspath(sys.argv.pop(1))
    MEMORY = int(sys.argv.pop(1)) << 20  # bytes
    PATIENCE *= int(sys.argv.pop(1))  # a program that is watched by a sanitizer is slower
    if sys.argv.pop(1) != "ON":
        del Editor
    if sys.argv.pop(1) != "ON":
        del Site
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    unittest.main()
