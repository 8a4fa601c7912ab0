"""The tables of a run: what was measured, and sums over the models."""

from .results import (best, geometric_mean, has_right_topology, is_closed, is_manifold, median,
                      ratio_to_front)
from .table import Table, number


def _metrics(row, prefix):
    return [number(row.get(prefix + "_" + key), 5) for key in ("hausdorff", "mean", "rms", "sd")]


def _yes(value):
    return None if value is None else "yes" if value else "no"


def _status(row):
    return "ok" if row["status"] == "ok" else "failed: %s %s" % (row["status"], row["message"])


def measures(results):
    columns = ["model", "method", "status", "V", "T", "points used", "H", "mean", "RMS", "SD",
               "H true", "mean true", "RMS true", "SD true", "boundary edges", "components", "Euler",
               "right topology", "non-manifold edges", "non-manifold vertices", "self-intersections",
               "regularity"]
    rows = []
    for model in results.models:
        reference = results.references.get(model["name"])
        keys = ["reference"] + results.keys()
        for key in keys:
            row = reference if key == "reference" else results.row(model["name"], key)
            if row is None or key == "reference" and not row.get("triangles"):
                continue
            title = "original" if key == "reference" else results.title(key)
            if row["status"] != "ok":
                rows.append([model["name"], title, _status(row)] + [None] * (len(columns) - 3))
                continue
            rows.append(
                [model["name"], title, _status(row), number(row["vertices"]), number(row["triangles"]),
                 "%s of %s" % (number(row["points_used"]), number(row["distinct_points"]))]
                + _metrics(row, "thesis") + _metrics(row, "true")
                + [number(row["boundary_edges"]), number(row["components"]), row["euler"],
                   _yes(has_right_topology(reference, row)), number(row["nonmanifold_edges"]),
                   number(row["nonmanifold_vertices"]), number(row.get("self_intersections")),
                   number(row["regularity_mean"], 4)])
    return Table("measures", "All measures", columns, rows,
                 "H, mean, RMS and SD (Eq. 3.14 to 3.18) are between the thesis's samples of both meshes; 'true' "
                 "are those to the true surface; in % of the diagonal of the bounding box of the points. "
                 "absolute.csv has them in the unit of the points.")


def absolute(results):
    keys = [prefix + "_" + key for prefix in ("thesis", "true") for key in ("hausdorff", "mean", "rms", "sd")]
    rows = []
    for row in results.all_rows:
        if row["status"] == "ok" and "diagonal" in row:
            rows.append([row["model"], row["method"], "%g" % row["diagonal"]]
                        + ["%.6g" % (row[key] * row["diagonal"] / 100) if key in row else None for key in keys])
    return Table("absolute", "Distances in the unit of the points", ["model", "method", "diagonal"] + keys, rows)


def times(results):
    return _times(results, results.all_rows, "times", "Times and memory")


def scaling(results):
    return _times(results, results.scaling, "scaling", "Times and memory against the number of points")


def _times(results, all_rows, name, title):
    columns = ["model", "method", "threads", "status", "points", "runs", "best s", "median s", "AF best s",
               "AF time / time", "normals s", "peak MB", "bytes a point"]
    rows = []
    for row in all_rows:
        if row["status"] not in ("ok", "not measured"):
            rows.append([row["model"], results.title(row["method"]), row["threads"], _status(row)]
                        + [None] * (len(columns) - 4))
            continue
        rows.append([row["model"], results.title(row["method"]), row["threads"], _status(row), number(row["points"]),
                     len(row["seconds"]), number(best(row), 4), number(median(row), 4),
                     number(best(row, "baseline_seconds"), 4), number(ratio_to_front(row), 2),
                     number(row["normal_seconds"], 3) if row["normal_seconds"] else None,
                     number(row["peak_bytes"] / 1e6, 1), number(row["growth_bytes"] / row["points"])])
    return Table(name, title, columns, rows,
                 "A process runs the method and the advancing front (AF) in turn; the ratio is of the best of both. "
                 "'normals' is the part of the time that estimates and orients normals that the points do not have. "
                 "Peak of the process at the end of the first run; bytes above the points.")


def regularity(results):
    columns = ["model", "method"] + ["%.2f" % (1 + 0.05 * i) for i in range(10)]
    rows = []
    for row in list(results.references.values()) + results.all_rows:
        if row["status"] == "ok" and row.get("triangles") and "regularity_histogram" in row:
            title = "original" if row["method"] == "reference" else results.title(row["method"])
            rows.append([row["model"], title] + [number(n) for n in row["regularity_histogram"]])
    return Table("regularity", "Histogram of the regularity of triangles (Eq. 3.1)", columns, rows,
                 "Triangles by the sum of the cosines of their angles; a column begins at its title and 1.5 is an "
                 "equilateral triangle.")


def summary(results):
    """One line a method over the models on which it ran with one thread."""
    columns = ["method", "models", "failed", "manifold", "closed", "right topology", "all points used",
               "free of self-intersection", "sum of H", "sum of means", "AF time / time"]
    rows = []
    for key in results.keys():
        found = [results.row(model["name"], key) for model in results.models]
        found = [row for row in found if row is not None]
        ok = [row for row in found if row["status"] == "ok"]
        topology = [has_right_topology(results.references.get(row["model"]), row) for row in ok]
        topology = [value for value in topology if value is not None]
        measured = [row for row in ok if "true_hausdorff" in row]
        counted = [row for row in ok if "self_intersections" in row]
        rows.append([results.title(key), len(found), len(found) - len(ok),
                     sum(is_manifold(row) for row in ok), sum(is_closed(row) for row in ok),
                     "%d of %d" % (sum(topology), len(topology)),
                     sum(row["points_used"] == row["distinct_points"] for row in ok),
                     "%d of %d" % (sum(row["self_intersections"] == 0 for row in counted), len(counted)),
                     "%.3f (%d)" % (sum(row["true_hausdorff"] for row in measured), len(measured)),
                     "%.4f (%d)" % (sum(row["true_mean"] for row in measured), len(measured)),
                     number(geometric_mean([ratio_to_front(row) for row in ok]), 2)])
    return Table("summary", "Summary", columns, rows,
                 "Counts of models. H and mean: to the true surface in % of the diagonal, summed over so many models "
                 "on which the method gave a result. Time: geometric mean over the models, one thread.")
