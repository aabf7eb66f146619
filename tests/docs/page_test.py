#!/usr/bin/env python3
"""Types what a page of the manual shows: page_test.py PROGRAMS PAGE.

In an empty folder and in the page's order: a block after <!-- file: NAME --> becomes that file; of a
block of kind "console", each line that begins with "$ " is run, and must print the lines that follow
it. There, "..." stands for any text, on a line of its own for any lines.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"(?:<!-- file: (\S+) -->\n)?```(\w+)\n(.*?)```", re.DOTALL)


def pattern_of(lines):
    """A regular expression for what is printed."""
    parts = [".*" if line == "..." else re.escape(line).replace(r"\.\.\.", "[^\n]*")
             for line in lines]
    return re.compile("\n".join(parts) + r"\s*", re.DOTALL)


def commands(block):
    """The commands of a console block, each with the lines that it prints."""
    for part in re.split(r"(?m)^\$ ", block)[1:]:
        command, *lines = part.rstrip("\n").split("\n")
        yield command, lines


def run(command, lines, folder):
    done = subprocess.run(["bash", "-c", command], cwd=folder, text=True, timeout=60,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if pattern_of(lines).fullmatch(done.stdout):
        return True
    print(f"$ {command}\n--- the page says\n" + "\n".join(lines) + f"\n--- it says\n{done.stdout}")
    return False


def main():
    programs, page = sys.argv[1:]
    os.environ["PATH"] = f"{programs}:{os.environ['PATH']}"
    typed = 0
    with tempfile.TemporaryDirectory() as folder:
        for file, kind, block in BLOCK.findall(pathlib.Path(page).read_text()):
            if file:
                (pathlib.Path(folder) / file).write_text(block)
            for command, lines in commands(block) if kind == "console" else []:
                typed += 1
                if not run(command, lines, folder):
                    sys.exit(1)
    if typed == 0:
        sys.exit(f"{page} has nothing to type")
    print(f"{typed} commands do what the page says")


if __name__ == "__main__":
    main()
