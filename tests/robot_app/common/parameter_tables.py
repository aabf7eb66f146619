#!/usr/bin/python3
"""The tables of docs/parameters.md: what the programs say of their parameters with --help.

    parameter_tables.py BIN             are the tables on the page right?
    parameter_tables.py BIN --write     makes them so
"""
import pathlib
import re
import subprocess
import sys

PROGRAMS = ("coppice-simulator", "coppice-simulated-cameras", "coppice-odometry-filter",
            "coppice-localization", "coppice-map-server", "coppice-mapping", "coppice-navigation",
            "coppice-docking", "coppice-people", "coppice-camera", "coppice-slam",
            "coppice-expression", "coppice-speech")
PAGE = pathlib.Path(__file__).resolve().parents[3] / "docs/parameters.md"
BEGIN, END = "<!-- tables: parameter_tables.py --write -->\n", "<!-- end of tables -->\n"


def table(bin_folder, program):
    text = subprocess.run([bin_folder / program, "--help"], check=True, capture_output=True,
                          text=True).stdout
    long_lines = [line for line in text.splitlines() if len(line) > 100]
    if long_lines:
        sys.exit(f"{program} --help has lines over 100 columns:\n" + "\n".join(long_lines))
    rows = [re.split(r" {2,}", line.strip()) for line in text.splitlines()
            if line.startswith("    ~")]
    lines = [f"## {program}", "", "| parameter | default | range | meaning |", "|---|---|---|---|"]
    lines += [f"| `{name}` | {value} | {limits} | {meaning} |"
              for name, value, limits, meaning in rows]
    return "\n".join(lines) + "\n"


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--write"]):
        sys.exit(__doc__)
    tables = "\n".join(table(pathlib.Path(sys.argv[1]), program) for program in PROGRAMS)
    before, rest = PAGE.read_text().split(BEGIN)
    right = before + BEGIN + tables + END + rest.split(END)[1]
    if sys.argv[2:]:
        PAGE.write_text(right)
    elif PAGE.read_text() != right:
        sys.exit(f"{PAGE} is not what the programs say: {sys.argv[0]} {sys.argv[1]} --write")


if __name__ == "__main__":
    main()
