#!/usr/bin/python3
"""Prints the tables of the manual's section "How Well Does It Work".

usage: summarize_quality.py FRONT.csv NAME=METHOD.csv...

The files are those of isr_compare: `isr_compare --runs 1 --method af --csv FRONT.csv FOLDER...`, and the same with
ctc, pcr or lis. Counted are models whose own mesh is closed, a manifold, oriented and free of self-intersections. A
hash of the name splits them in two halves; sizes of one model are in the same half."""

import csv
import hashlib
import sys

COLUMNS = ["models", "closed", "topology", "no crossing", "H", "mean", "sum of H", "sum of means"]


def load(file):
    models = {}
    with open(file, newline="") as source:
        for row in csv.DictReader(source):
            models.setdefault(row["model"], {})[row["method"]] = row
    return models


def half(model):
    name = model.replace("_small", "").replace("_large", "")
    return int(hashlib.md5(name.encode()).hexdigest(), 16) % 2


def is_clean(reference):
    return (reference["b_edges"] == reference["nm_e"] == reference["nm_v"] == "0" and reference["orient"] == "yes"
            and reference["crossings"] in ("0", ""))


def facts(row, reference, front):
    """What is summed over the models; a result that is no better than the front's is as good if equal."""
    closed = row["b_edges"] == "0"
    at_most = [float(row[key]) <= float(front[key]) * (1 + 1e-9) + 1e-12 for key in ("H%", "mean%")]
    return [1, closed, closed and row["euler"] == reference["euler"] and row["comp"] == reference["comp"],
            row["crossings"] in ("0", "")] + at_most + [float(row["H%"]), float(row["mean%"])]


def describe(model, row, front, reference):
    return "| %s | %s | %s | %s / %s / %s | %s / %s | %s | %s / %s | %s / %s |" % (
        model, "12"[half(model)], row["points"], row["euler"], front["euler"], reference["euler"], row["b_edges"],
        front["b_edges"], row["crossings"], row["H%"], front["H%"], row["mean%"], front["mean%"])


def main():
    front = load(sys.argv[1])
    print("| variant | half | " + " | ".join(COLUMNS) + " |")
    failures = []
    for name, file in (word.split("=", 1) for word in sys.argv[2:]):
        sums = {0: [0.] * len(COLUMNS), 1: [0.] * len(COLUMNS)}
        for model, rows in sorted(load(file).items()):
            reference = rows["reference"]
            row = next(rows[method] for method in rows if method != "reference")
            if not is_clean(reference):
                continue
            found = facts(row, reference, front[model]["AF"])
            sums[half(model)] = [a + b for a, b in zip(sums[half(model)], found)]
            if not found[2]:
                failures.append("%s: %s" % (name, describe(model, row, front[model]["AF"], reference)))
        for number, found in sums.items():
            print("| %s | %d | %s | %.1f | %.2f |" % (
                name, number + 1, " | ".join("%d" % value for value in found[:6]), *found[6:]))
    print("\nWrong topology: model, half, points, Euler (method / front / original), boundary edges, crossings, H, mean")
    print("\n".join(failures))


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main()
