"""The pictures of the meshes, one row a model."""

import json
import os

from PIL import Image

HERE = os.path.dirname(os.path.abspath(__file__))


def _jpeg(results_folder, row):
    """The picture of a row, compressed; the file that the rasterizer wrote is removed."""
    source = os.path.join(results_folder, row["picture"])
    target = os.path.splitext(source)[0] + ".jpg"
    if os.path.exists(source):
        Image.open(source).save(target, quality=82, optimize=True)
        os.remove(source)
    return target if os.path.exists(target) else None


def _caption(row):
    words = ["%s triangles" % "{:,}".format(row["triangles"])]
    if "true_hausdorff" in row:
        words.append("H %.3f %%, mean %.4f %%" % (row["true_hausdorff"], row["true_mean"]))
    if row["boundary_edges"]:
        words.append("%d boundary edges" % row["boundary_edges"])
    if row["nonmanifold_edges"] + row["nonmanifold_vertices"]:
        words.append("%d non-manifold edges and vertices" % (row["nonmanifold_edges"] + row["nonmanifold_vertices"]))
    if row.get("self_intersections"):
        words.append("%d self-intersections" % row["self_intersections"])
    if row["points_used"] < row["distinct_points"]:
        words.append("%d points unused" % (row["distinct_points"] - row["points_used"]))
    return ", ".join(words)


def _holds(need, results):
    """Whether what a sentence says was measured in this run as well."""
    row = results.row(need["model"], need["method"])
    if row is None:
        return False
    if "status" in need:
        return row["status"] == need["status"]
    if row["status"] != "ok" or need["key"] not in row:
        return False
    value, limit = row[need["key"]], need["value"]
    return {"=": value == limit, "<": value < limit, ">": value > limit}[need["is"]]


def observations(results):
    """What was seen in the pictures, as far as this run shows the same."""
    with open(os.path.join(HERE, "observations.json")) as file:
        entries = json.load(file)
    result = {}
    for entry in entries:
        needs = [dict(need, model=entry["model"]) for need in entry["needs"]]
        if all(_holds(need, results) for need in needs):
            result.setdefault(entry["model"], []).append(entry["text"])
    return result


def picture_rows(results, folder):
    """For every model: its name and the titles, captions and files of its pictures."""
    rows = []
    for model in results.models:
        pictures = []
        reference = results.references.get(model["name"])
        if reference and reference.get("picture"):
            if reference["triangles"]:
                caption = _caption(reference)
            else:
                caption = "%s points" % "{:,}".format(reference["points"])
            pictures.append(("original" if reference["triangles"] else "points", caption, _jpeg(folder, reference)))
        for key in results.keys():
            row = results.row(model["name"], key)
            if row is None:
                continue
            if row["status"] == "ok" and row.get("picture"):
                pictures.append((results.title(key), _caption(row), _jpeg(folder, row)))
            else:
                pictures.append((results.title(key), "failed: %s %s" % (row["status"], row["message"]), None))
        rows.append((model["name"], pictures))
    return rows
