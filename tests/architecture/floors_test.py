#!/usr/bin/python3
"""Does the code stand on its floors? Reads the includes of all sources and holds them against
rooms.py."""
import re
import subprocess
import unittest

import rooms

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
MOST_FILES = 40  # in one folder: more cannot be taken in at a glance


def sources():
    found = []
    for top in (*rooms.WINGS, "tests"):
        found += [p.relative_to(rooms.ROOT).as_posix() for p in (rooms.ROOT / top).rglob("*")
                  if p.suffix in (".h", ".cc")]
    return sorted(found)


def folder(path):
    return path.rpartition("/")[0]


def circles(arrows):
    """Groups of folders that can all be reached from each other (Tarjan, IEEE 1972)."""
    index, low, stack, groups = {}, {}, [], []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for to in sorted(arrows.get(node, ())):
            if to not in index:
                visit(to)
            if to in stack:
                low[node] = min(low[node], low[to])
        if low[node] == index[node]:
            group = stack[stack.index(node):]
            del stack[stack.index(node):]
            if len(group) > 1:
                groups.append(sorted(group))

    for node in sorted(arrows):
        if node not in index:
            visit(node)
    return groups


class FloorsTest(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        cls.floors = rooms.floor_of_rooms()
        cls.files = sources()
        cls.shipped = [f for f in cls.files if not f.startswith("tests/")]
        cls.includes = [(f, match[1], match[2]) for f in cls.shipped
                        for match in INCLUDE.finditer((rooms.ROOT / f).read_text())]
        known = set(cls.files)
        cls.own = [(f, to) for f, _, to in cls.includes if to in known]

    def room(self, path):
        return rooms.room_of(folder(path), self.floors)

    def test_no_comment_is_wider_than_the_code(self):
        wide = [f"{f}:{number}" for f in self.files
                for number, line in enumerate((rooms.ROOT / f).read_text().split("\n"), 1)
                if len(line) > 100 and line.lstrip().startswith("//")]
        self.assertEqual(wide, [])

    def test_every_source_lies_in_a_room(self):
        homeless = sorted({folder(f) for f in self.shipped if self.room(f) is None})
        self.assertEqual(homeless, [], "give these folders a line in tests/architecture/rooms.py")

    def test_every_room_is_there(self):
        folders = {folder(f) for f in self.shipped}
        gone = [room for room in self.floors
                if not any(f == room or f.startswith(room + "/") for f in folders)]
        self.assertEqual(gone, [])

    def is_allowed(self, here, there):
        if not here or not there:
            return True  # said by the test above
        if here == there or (here, there) in rooms.ARROWS:
            return True
        if there in rooms.PROGRAMS:
            return False
        wing, other = here.split("/")[0], there.split("/")[0]
        if wing != other:
            return other in rooms.WINGS[wing]
        return self.floors[there] < self.floors[here]

    def test_a_room_includes_only_lower_floors(self):
        wrong = [f"{f} includes {to}" for f, to in self.own
                 if not self.is_allowed(self.room(f), self.room(to))]
        self.assertEqual(wrong, [], "an arrow goes up or sideways")

    def test_the_named_arrows_are_needed(self):
        drawn = {(self.room(f), self.room(to)) for f, to in self.own}
        self.assertEqual([arrow for arrow in rooms.ARROWS if arrow not in drawn], [])

    def test_folders_include_each_other_in_no_circle(self):
        arrows = {}
        for f, to in self.own:
            if folder(f) != folder(to):
                arrows.setdefault(folder(f), set()).add(folder(to))
        found = {}  # by the rooms that the circle goes through
        for circle in circles(arrows):
            through = {rooms.room_of(f, self.floors) for f in circle}
            found[", ".join(sorted(through))] = circle
        self.assertEqual([c for r, c in found.items() if r not in rooms.INNER_CIRCLES], [])
        self.assertEqual([r for r in rooms.INNER_CIRCLES if r not in found], [],
                         "no circle any more: strike it off the list")

    def test_libraries_stay_where_they_belong(self):
        wrong = []
        for f, kind, to in self.includes:
            for name, (pattern, anywhere, in_headers) in rooms.FOREIGN.items():
                places = in_headers if f.endswith(".h") else anywhere
                allowed = any((f + "/").startswith(place + "/") for place in places)
                if kind == "<" and re.match(pattern, to) and not allowed:
                    wrong.append(f"{f} includes {name}: <{to}>")
        self.assertEqual(wrong, [])

    def test_no_folder_is_too_full(self):
        count = {}
        for f in self.files:
            count[folder(f)] = count.get(folder(f), 0) + 1
        self.assertEqual({f: n for f, n in count.items() if n > MOST_FILES}, {})

    def test_the_picture_of_the_rooms_is_that_of_the_table(self):
        self.assertEqual(rooms.PICTURE.read_text(), rooms.picture(), "run rooms.py --write")

    def test_the_page_has_the_table(self):
        text = rooms.PAGE.read_text()
        self.assertEqual(text, rooms.page(text), "run rooms.py --write")


class CirclesTest(unittest.TestCase):
    def test_a_circle_is_found_behind_an_arrow(self):
        self.assertEqual(circles({"a": {"b"}, "b": {"c"}, "c": {"b", "d"}}), [["b", "c"]])

    def test_a_diamond_is_no_circle(self):
        self.assertEqual(circles({"a": {"b", "c"}, "b": {"d"}, "c": {"d"}}), [])


if __name__ == "__main__":
    unittest.main()
