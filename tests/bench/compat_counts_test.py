"""Holds what the interface of BehaviorTree.CPP costs: instructions under callgrind, which are the
same on every machine for one compiler. docs/migration.md has the figures.

usage: compat_counts_test.py COPPICE_COMPAT_BENCH
"""
import re
import subprocess
import sys
import unittest

READS = 1000  # in each round
ROUNDS = 2
TICKS = 10


def instructions(case, rounds):
    ended = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null",
                            PROGRAM, case, str(rounds)], capture_output=True, text=True)
    found = re.search(r"Collected : (\d+)", ended.stderr)
    assert found and ended.returncode == 0, ended.stderr
    return int(found.group(1))


class Counts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.start = instructions("int key", 0)  # of the program, whatever port is read

    def per_call(self, case):
        return (instructions(case, ROUNDS) - self.start) / (ROUNDS * READS)

    def test_an_input_is_read_in_60_instructions(self):
        for case in ("int literal", "double key", "bool key", "enum key", "expected double key"):
            self.assertLessEqual(self.per_call(case), 60, case)

    def test_a_text_is_read_in_60_instructions_beside_those_of_its_copy(self):
        copy = self.per_call("copy of the string")
        self.assertLessEqual(self.per_call("string key") - copy, 60)

    def test_an_output_is_written_in_150_instructions(self):
        self.assertLessEqual(self.per_call("set double"), 150)

    def test_a_tree_of_a_hundred_leaves_is_ticked_in_6500_instructions(self):
        more = instructions("tick", 1 + TICKS) - instructions("tick", 1)
        self.assertLessEqual(more / TICKS, 6500)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
