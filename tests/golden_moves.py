#!/usr/bin/env python3
"""Prints each golden line that differs between two files of tests/golden.sh --states, with the largest change of a position in metres.

  tests/golden_moves.py FROM TO

A line of such a file is the name, the hash, and the positions of all balls every 0.1 s. Lines of aims have velocities instead, in m/s.
"""
import math
import re
import sys

LINE = re.compile(r"(.*?) ([0-9a-f]{16}|[0-9a-f]{33,})((?: [-+.0-9eE]+)*)$")


def read(path):
    """Returns the hash and the numbers of each line, by its name."""
    lines = {}
    with open(path, encoding="ascii") as file:
        for line in file:
            name, bits, numbers = LINE.match(line.rstrip("\n")).groups()
            lines[name] = bits, [float(number) for number in numbers.split()]
    return lines


def change(before, after):
    """Returns the largest distance between points of two paths, in m."""
    points = range(0, len(before), 3)
    return max((math.dist(before[i:i + 3], after[i:i + 3]) for i in points), default=0.0)


def main():
    before, after = (read(path) for path in sys.argv[1:3])
    moved = 0
    largest = 0.0
    for name, (bits, path) in after.items():
        if name not in before:
            print(f"{'new':>12}    {name}")
        elif len(before[name][1]) != len(path):
            print(f"{'other balls':>12}    {name}")
        elif before[name][0] != bits and not name.startswith("total"):
            metres = change(before[name][1], path)
            moved += 1
            largest = max(largest, metres)
            print(f"{metres:12.2e} m  {name}")
    for name in before.keys() - after.keys():
        print(f"{'removed':>12}    {name}")
    print(f"{moved} of {len(after)} lines moved, by at most {largest:.2e} m")


if __name__ == "__main__":
    main()
