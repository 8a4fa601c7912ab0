#!/usr/bin/python3
"""Usage: test_isr_quality.py ISR_DERIVED_MESHES ISR_COMPARE DIRECTORY

The meshes that isr_derived_meshes makes of a sphere are spheres with as many edges as it says, and isr_compare has a row for
each that tells so, and that CTC has reconstructed it."""

import csv
import os
import subprocess
import sys


def octahedron(levels):
    vertices = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    triangles = [(i, j, k) if (i + j + k) % 2 == 0 else (i, k, j) for i in (0, 1) for j in (2, 3) for k in (4, 5)]
    for _ in range(levels):
        midpoints = {}

        def midpoint(i, j):
            if frozenset((i, j)) not in midpoints:
                middle = [(a + b) / 2 for a, b in zip(vertices[i], vertices[j])]
                length = sum(a * a for a in middle) ** .5
                midpoints[frozenset((i, j))] = len(vertices)
                vertices.append(tuple(a / length for a in middle))
            return midpoints[frozenset((i, j))]

        finer = []
        for i, j, k in triangles:
            a, b, c = midpoint(i, j), midpoint(j, k), midpoint(k, i)
            finer += [(i, a, c), (a, j, b), (c, b, k), (a, b, c)]
        triangles = finer
    return vertices, triangles


def write_off(path, vertices, triangles):
    with open(path, "w") as file:
        file.write(f"OFF\n{len(vertices)} {len(triangles)} 0\n")
        file.writelines("%.17g %.17g %.17g\n" % v for v in vertices)
        file.writelines("3 %d %d %d\n" % t for t in triangles)


def require(condition, what):
    if not condition:
        sys.exit(f"FAILED: {what}")


def main():
    derive, compare, directory = sys.argv[1:]
    meshes, rows = os.path.join(directory, "meshes"), os.path.join(directory, "rows.csv")
    os.makedirs(meshes, exist_ok=True)
    vertices, triangles = octahedron(4)
    sphere = os.path.join(directory, "sphere.off")
    write_off(sphere, vertices, triangles)
    opened = os.path.join(directory, "open.off")
    write_off(opened, vertices, triangles[1:])
    subprocess.run([derive, meshes, sphere, opened], check=True)
    names = ["sphere_c2", "sphere_c5", "sphere_r1", "sphere_r2"]
    require(sorted(os.listdir(meshes)) == [name + ".off" for name in names], "not four meshes of the closed one alone")

    subprocess.run([compare, "--runs", "1", "--method", "ctc", "--csv", rows, meshes], check=True)
    with open(rows) as file:
        found = list(csv.DictReader(file))
    require([(row["model"], row["method"]) for row in found] ==
            [(name, method) for name in names for method in ("reference", "CTC")], "not a row for each mesh and method")
    for row in found:
        require((row["comp"], row["euler"], row["b_edges"], row["crossings"]) == ("1", "2", "0", "0"),
                f"{row['model']} by {row['method']} is no sphere")
        require(row["used"] == row["points"], f"{row['model']} by {row['method']} leaves points out")
        require(float(row["H%"] if row["method"] == "CTC" else 0) < 5, f"{row['model']} by CTC is far off")
    triangles_of = {row["model"]: int(row["triangles"]) for row in found if row["method"] == "reference"}
    for name, share, tolerance in (("c5", .5, .01), ("c2", .2, .01), ("r1", 1, .3), ("r2", .25, .3)):
        expected = share * len(triangles)
        require(abs(triangles_of["sphere_" + name] - expected) < tolerance * expected, f"sphere_{name} is too fine or coarse")
    print("passed")


if __name__ == "__main__":
    main()
