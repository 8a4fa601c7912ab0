"""Facts that must hold of a complete run."""

import os

from . import thesis
from .results import is_manifold, is_run

REQUIRED = ["vertices", "triangles", "points_used", "distinct_points", "components", "boundary_edges", "euler",
            "nonmanifold_edges", "nonmanifold_vertices", "regularity_mean", "seconds", "peak_bytes"]
DISTANCES = ["true_hausdorff", "true_mean", "true_rms", "true_sd"]


def _require(condition, message):
    if not condition:
        raise SystemExit("check failed: " + message)


def _check_files(output):
    names = ["summary", "measures", "absolute", "times", "scaling", "ratios", "regularity", "models", "originals"]
    names += ["table-" + table.replace(".", "-")
              for table in [entry[0] for entry in thesis.MESH_TABLES + thesis.TIME_TABLES]]
    for name in names:
        for extension in (".csv", ".md", ".tex"):
            file = os.path.join(output, "tables", name + extension)
            _require(os.path.exists(file) and os.path.getsize(file) > 0, file + " is missing")
    for name in ("index.html", "tables/claims.md", "plots/regularity.svg", "plots/figure-4-14.svg"):
        _require(os.path.getsize(os.path.join(output, name)) > 0, name + " is missing")
    with open(os.path.join(output, "index.html"), encoding="utf-8") as file:
        text = file.read()
    _require("src='http" not in text and "<link" not in text, "the page needs other files")
    return text


def _check_row(results, row):
    name = "%s, %s" % (row["model"], row["method"])
    for key in REQUIRED:
        _require(key in row, name + ": no " + key)
    reference = results.references[row["model"]]
    if "true_euler" in row or reference.get("triangles"):
        for key in DISTANCES:
            _require(row.get(key, -1) >= 0, name + ": no " + key)
        _require(row["true_mean"] <= row["true_rms"] * (1 + 1e-9) <= row["true_hausdorff"] * (1 + 2e-9),
                 name + ": mean, RMS and H out of order")


def check(results, output):
    text = _check_files(output)
    ours = {method["key"] for method in results.methods if method["is_ours"]}
    expected = {(model["name"], method["key"]) for model in results.models for method in results.methods
                if is_run(method, results.references[model["name"]], results.largest_of_peers)}
    found = {(row["model"], row["method"]) for row in results.all_rows}
    _require(expected == found, "rows are missing: %s" % sorted(expected - found))
    pictures = 0
    for row in results.all_rows:
        name = "%s, %s: " % (row["model"], row["method"])
        if row["status"] != "ok":
            _require(row["method"] not in ours, name + row["status"] + " " + row["message"])
            _require(row["message"] != "" or row["status"] == "crash", name + "failed without a reason")
            continue
        _check_row(results, row)
        pictures += 1
        if row["method"] in ours:
            _require(row["triangles"] > 0 and is_manifold(row) and row["oriented"] == 1, name + "not a manifold")
            _require(row["interpolates"] == 1, name + "vertices that are no points")
    _require(text.count("data:image/jpeg") >= pictures // 2, "pictures are missing in the page")
    print("checked: %d rows complete, %d of our own manifold and oriented" % (
        len(results.all_rows), sum(row["method"] in ours for row in results.all_rows)))
