#!/usr/bin/python3
"""Medians and Cronbach's alpha of made-up answers, against Python's statistics module.

usage: alpha_of_others_test.py coppice-questionnaire
"""
import csv
import random
import statistics
import subprocess
import sys
import tempfile

SCALES = {"Anthropomorphism": ("anthropomorphism", 5), "Animacy": ("animacy", 6),
          "Likeability": ("likeability", 5), "Perceived Intelligence": ("intelligence", 5),
          "Perceived Safety": ("safety", 3)}
PEOPLE = 12


def answers():
    chance = random.Random(7)
    people = []
    for _ in range(PEOPLE):
        leaning = chance.uniform(1, 5)
        people.append([min(5, max(1, round(chance.gauss(leaning, 1))))
                       for _, count in SCALES.values() for _ in range(count)])
    return people


def alpha(rows):
    k = len(rows[0])
    items = sum(statistics.variance(column) for column in zip(*rows))
    return k / (k - 1) * (1 - items / statistics.variance([sum(row) for row in rows]))


def main(program):
    people = answers()
    with tempfile.NamedTemporaryFile("w", suffix=".csv", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(f"{name}_{i + 1}" for name, count in SCALES.values() for i in range(count))
        writer.writerows(people)
        file.flush()
        text = subprocess.run([program, file.name, "--figures"], check=True, capture_output=True,
                              text=True).stdout
    first = 0
    for name, (_, count) in SCALES.items():
        rows = [person[first:first + count] for person in people]
        first += count
        medians = " ".join(f"{statistics.median(column):g}" for column in zip(*rows))
        line = next(line for line in text.splitlines() if line.startswith(name))
        assert f"{alpha(rows):.2f}" == line[len(name):].split()[0], (line, alpha(rows))
        assert f"  {medians} " in line, (line, medians)


if __name__ == "__main__":
    main(sys.argv[1])
