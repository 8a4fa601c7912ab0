#!/usr/bin/python3
"""Samples of the manual's section "How Well Does It Work" that no model gives: rows of points, openings, and parts.

usage: quality_samples.py rows FOLDER [RATIO...]
       quality_samples.py openings FOLDER
       quality_samples.py parts FOLDER
       quality_samples.py edges FOLDER
       quality_samples.py count FILE.csv...

rows writes samples of tori, a sphere and a terrain in rows RATIO times (3, 5, 10, 20, 40) as far from each other as the
points in them: as in a grid, with each row shifted, and with each point moved in its row. openings writes spheres
whose top is cut off, with noise. parts writes milled parts with points on their walls only, in random rotations, and
edges those with points on the edges of their two faces only. count tells how many of them a method got right, from
`isr_compare --runs 1 --csv FILE.csv --method METHOD FOLDER`: one component with the Euler characteristic of the surface
and, of the openings, one loop."""

import csv
import math
import os
import random
import sys

RATIOS = [3, 5, 10, 20, 40]
ROWS = {"torus-across": 32, "torus-along": 20, "sphere": 20, "terrain": 25}
EULER = {"torus-across": "0", "torus-along": "0", "sphere": "2", "terrain": "1", "opening": "1", "block": "2",
         "frame": "0", "plate": "0", "three-holes": "-4", "flange": "-10"}
KINDS = ["grid", "shifted", "moved"]

# Of the spacing, to either side: the order of the points in a row stays.
MOVE = .4


def on_torus(u, v):
    ring = 1 + .4 * math.cos(v)
    return ring * math.cos(u), ring * math.sin(u), .4 * math.sin(v)


def positions_in_row(number, kind, generator):
    """Of `number` points, in spacings."""
    shift = 0 if kind == "grid" else generator.random()
    return [i + shift + (generator.uniform(-MOVE, MOVE) if kind == "moved" else 0) for i in range(number)]


def angles(number, kind, generator):
    return [2 * math.pi * x / number for x in positions_in_row(number, kind, generator)]


def torus_across(rows, ratio, kind, generator):
    number = round(.4 * rows * ratio)
    return [on_torus(2 * math.pi * i / rows, v) for i in range(rows) for v in angles(number, kind, generator)]


def torus_along(rows, ratio, kind, generator):
    number = round(rows * ratio / .4)
    return [on_torus(u, 2 * math.pi * i / rows) for i in range(rows) for u in angles(number, kind, generator)]


def sphere(rows, ratio, kind, generator):
    points = [(0, 0, 1), (0, 0, -1)]
    for i in range(1, rows):
        polar = math.pi * i / rows
        number = max(3, round(2 * rows * ratio * math.sin(polar)))
        points += [(math.sin(polar) * math.cos(u), math.sin(polar) * math.sin(u), math.cos(polar))
                   for u in angles(number, kind, generator)]
    return points


def terrain(rows, ratio, kind, generator):
    points = []
    for i in range(rows + 1):
        y = i / rows
        points += [(x / (rows * ratio), y, .08 * math.sin(6 * x / (rows * ratio)) * math.cos(7 * y))
                   for x in positions_in_row(rows * ratio + 1, kind, generator)]
    return points


def opening(number, height, noise, generator):
    """Of a Fibonacci sphere of so many points, up to a height; the noise is in spacings."""
    half = noise * math.sqrt(4 * math.pi / number)
    points = []
    for i in range(number):
        z = 1 - (2 * i + 1) / number
        radius, angle = math.sqrt(1 - z * z), math.pi * (3 - math.sqrt(5)) * i
        if z <= height:
            points.append([x + generator.uniform(-half, half)
                           for x in (radius * math.cos(angle), radius * math.sin(angle), z)])
    return points


def number_of(length, spacing):
    return max(1, round(length / spacing))


def circle(x, y, radius, spacing):
    number = number_of(2 * math.pi * radius, spacing)
    return [(x + radius * math.cos(2 * math.pi * i / number), y + radius * math.sin(2 * math.pi * i / number))
            for i in range(number)]


def rectangle(x, y, width, depth, spacing):
    across, along = number_of(width, spacing), number_of(depth, spacing)
    right = [width * i / across for i in range(across)]
    up = [depth * i / along for i in range(along)]
    return ([(x + d, y) for d in right] + [(x + width - d, y + depth) for d in right] +
            [(x + width, y + d) for d in up] + [(x, y + depth - d) for d in up])


def profiles(spacing):
    """Of the parts: the edges of their two faces."""
    square, long = rectangle(0, 0, 3, 3, spacing), rectangle(0, 0, 6, 3, spacing)
    bolts = [circle(2 * math.cos(2 * math.pi * i / 5), 2 * math.sin(2 * math.pi * i / 5), .4, spacing)
             for i in range(5)]
    return {
        "block": square,
        "frame": square + rectangle(.5, .5, 2, 2, spacing),
        "plate": square + circle(1.5, 1.5, .7, spacing),
        "three-holes": long + sum((circle(x, 1.5, .5, spacing) for x in (1.2, 3, 4.8)), []),
        "flange": circle(0, 0, 3, spacing) + circle(0, 0, .6, spacing) + sum(bolts, []),
    }


def random_rotation(generator):
    w, x, y, z = (generator.gauss(0, 1) for _ in range(4))
    norm = w * w + x * x + y * y + z * z
    return [[1 - 2 * (y * y + z * z) / norm, 2 * (x * y - z * w) / norm, 2 * (x * z + y * w) / norm],
            [2 * (x * y + z * w) / norm, 1 - 2 * (x * x + z * z) / norm, 2 * (y * z - x * w) / norm],
            [2 * (x * z - y * w) / norm, 2 * (y * z + x * w) / norm, 1 - 2 * (x * x + y * y) / norm]]


def part(profile, height, layers, rotation):
    points = [(x, y, height * i / layers) for i in range(layers + 1) for x, y in profile]
    return [[sum(a * b for a, b in zip(row, p)) for row in rotation] for p in points]


def write(folder, name, points):
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, name + ".xyz"), "w") as file:
        file.writelines("%.9g %.9g %.9g\n" % tuple(p) for p in points)


def write_rows(folder, ratios):
    generator = random.Random(7)
    surfaces = {"torus-across": torus_across, "torus-along": torus_along, "sphere": sphere, "terrain": terrain}
    for ratio in ratios:
        for name, sample in surfaces.items():
            for kind in KINDS:
                write(folder, "%s_%d_%s" % (name, ratio, kind), sample(ROWS[name], ratio, kind, generator))


def write_openings(folder):
    generator = random.Random(1)
    for number in (1500, 4000, 16000):
        for height in (0, .6, .8, .95):
            for noise in (0, .1, .3):
                write(folder, "opening_%d_%g_%g" % (number, height, noise), opening(number, height, noise, generator))


def write_parts(folder, is_wall_sampled):
    generator = random.Random(1)
    for spacing in (.1, .13, .2, .27):
        for name, profile in profiles(spacing).items():
            for height in (.6, 1, 2):
                layers = number_of(height, spacing) if is_wall_sampled else 1
                for time in range(3):
                    write(folder, "%s_%g_%g_%d" % (name, spacing, height, time),
                          part(profile, height, layers, random_rotation(generator)))


def is_right(row):
    surface = row["model"].split("_")[0]
    if row["comp"] != "1" or row["euler"] != EULER[surface]:
        return False
    return surface == "terrain" or row["loops"] == ("1" if surface == "opening" else "0")


def count(file):
    with open(file, newline="") as source:
        rows = [row for row in csv.DictReader(source) if row["method"] != "reference"]
    for method in sorted({row["method"] for row in rows}):
        of_method = [row for row in rows if row["method"] == method]
        wrong = [row["model"] for row in of_method if not is_right(row)]
        print("%s %s: %d of %d, %.1f s; wrong: %s" %
              (file, method, len(of_method) - len(wrong), len(of_method),
               sum(float(row["min_s"]) for row in of_method), ", ".join(wrong) or "none"))


def main():
    words = sys.argv[1:]
    if len(words) >= 2 and words[0] == "rows":
        write_rows(words[1], [int(word) for word in words[2:]] or RATIOS)
    elif len(words) == 2 and words[0] == "openings":
        write_openings(words[1])
    elif len(words) == 2 and words[0] in ("parts", "edges"):
        write_parts(words[1], words[0] == "parts")
    elif len(words) >= 2 and words[0] == "count":
        for file in words[1:]:
            count(file)
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
