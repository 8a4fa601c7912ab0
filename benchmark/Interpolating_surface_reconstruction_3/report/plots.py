"""The thesis's figures as plots, and time and memory against the number of points."""

import math
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from . import thesis  # noqa: E402
from .results import best  # noqa: E402

COLORS = {"ctc": "#1b6ca8", "ctc-thesis": "#7fb7de", "pcr": "#0b8457", "lis": "#6a3d9a",
          "lis-thesis": "#b59ad0", "af": "#e08e0b", "power-crust": "#8c6d46", "scale-space": "#c23b22",
          "poisson": "#777777"}
MARKERS = {"ctc": "o", "ctc-thesis": "h", "pcr": "s", "lis": "D", "lis-thesis": "d", "af": "^",
           "power-crust": "P", "scale-space": "v", "poisson": "X"}

# Figure of the thesis: chapter, quantity.
FIGURES = [
    ("3.8", 3, "difference"), ("3.11", 3, "thesis_hausdorff"), ("3.12", 3, "thesis_mean"),
    ("3.13", 3, "thesis_rms"), ("3.14", 3, "thesis_sd"), ("3.15", 3, "seconds"),
    ("4.11", 4, "difference"), ("4.14", 4, "thesis_hausdorff"), ("4.15", 4, "thesis_mean"),
    ("4.16", 4, "thesis_rms"), ("4.17", 4, "thesis_sd"), ("4.18", 4, "seconds"),
    ("5.5", 5, "thesis_hausdorff"), ("5.6", 5, "thesis_mean"), ("5.7", 5, "thesis_rms"), ("5.8", 5, "thesis_sd")]

LABELS = {"difference": "|triangles − original| (count)", "thesis_hausdorff": "H (% of the diagonal)",
          "thesis_mean": "mean distance (%)", "thesis_rms": "RMS distance (%)",
          "thesis_sd": "SD of the distance (%)", "seconds": "seconds (best run)"}


def _style(key):
    return {"color": COLORS.get(key, "#333333"), "marker": MARKERS.get(key, "*")}


def _legend(axes, **options):
    if axes.get_legend_handles_labels()[0]:  # none if every method failed
        axes.legend(fontsize=7, frameon=False, **options)


def _save(figure, folder, name):
    file = os.path.join(folder, name + ".svg")
    figure.tight_layout()
    figure.savefig(file, metadata={"Date": None})
    plt.close(figure)
    return file


def _quantity(results, name, key, quantity):
    row = results.ok(name, key)
    if row is None:
        return None
    if quantity == "seconds":
        return best(row)
    if quantity == "difference":
        return abs(row["triangles"] - results.references[name]["triangles"])
    return row.get(quantity)


def _has_failed(results, name, key):
    return results.row(name, key) is not None and results.ok(name, key) is None


def _compared_models(results):
    """The thesis's models in its order; without any of them, all models."""
    names = [model["name"] for model in results.models
             if results.references.get(model["name"], {}).get("triangles")]
    ordered = [model["model"] for model in thesis.MODELS if model["model"] in names]
    if ordered:
        return ordered
    return names or [model["name"] for model in results.models]


def _comparison(results, folder, number, chapter, quantity):
    keys = [key for key in thesis.CHAPTER_METHODS[chapter] if results.has(key)]
    names = _compared_models(results)
    if not any(results.references.get(name, {}).get("triangles") for name in names):
        if quantity == "difference":
            return None
        quantity = quantity.replace("thesis_", "true_")
    values = {key: [_quantity(results, name, key, quantity) for name in names] for key in keys}
    positive = [value for column in values.values() for value in column if value]
    floor = min(positive) / 3 if positive else 1
    figure, axes = plt.subplots(figsize=(8.5, 3.6))
    for i, key in enumerate(keys):
        shift = 0.6 * (i - (len(keys) - 1) / 2) / max(len(keys), 1)
        places = [j + shift for j, value in enumerate(values[key]) if value is not None]
        heights = [max(value, floor) for value in values[key] if value is not None]
        axes.plot(places, heights, linestyle="none", label=results.title(key), markersize=6, **_style(key))
        failed = [j + shift for j, name in enumerate(names) if _has_failed(results, name, key)]
        for place in failed:
            axes.text(place, 0.985, "failed", rotation=90, ha="center", va="top", fontsize=6, color=COLORS.get(key),
                      transform=axes.get_xaxis_transform())
    axes.set_yscale("log")
    if any(value == 0 for column in values.values() for value in column):
        axes.axhline(floor, color="#bbbbbb", linewidth=0.8)
        axes.text(1.005, floor, "zero", va="center", fontsize=7, color="#666666", transform=axes.get_yaxis_transform())
    same = {model["model"] for model in thesis.MODELS
            if thesis.is_same_mesh(model, results.references.get(model["model"]))}
    axes.set_xticks(range(len(names)))
    axes.set_xticklabels([name + ("*" if name in same else "") for name in names], rotation=30, ha="right",
                         fontsize=8)
    axes.set_xlim(-0.6, len(names) - 0.4)
    for j in range(1, len(names)):
        axes.axvline(j - 0.5, color="#eeeeee", linewidth=0.8, zorder=0)
    axes.set_ylabel(LABELS[quantity.replace("true_", "thesis_")], fontsize=9)
    axes.grid(axis="y", color="#dddddd", linewidth=0.5)
    _legend(axes, ncol=4, loc="lower left", bbox_to_anchor=(0, 1.0))
    return _save(figure, folder, "figure-" + number.replace(".", "-"))


def fitted_exponent(points):
    """Slope of the line through the points of a log-log plot, least squares; needs three."""
    logs = [(math.log(x), math.log(y)) for x, y in points if x > 0 and y > 0]
    if len(logs) < 3:
        return None
    mean_x = sum(x for x, _ in logs) / len(logs)
    mean_y = sum(y for _, y in logs) / len(logs)
    return (sum((x - mean_x) * (y - mean_y) for x, y in logs) / sum((x - mean_x) ** 2 for x, _ in logs))


def scaling_points(results, key, threads, value):
    rows = [row for row in results.scaling
            if row["method"] == key and row["threads"] == threads and row["status"] == "ok"]
    return sorted((row["points"], value(row)) for row in rows)


def _scaling(results, folder, name, label, value, fitted=None, fitted_from=0):
    """A line a method; the exponent is that of `fitted`, or of the values, from so many points on."""
    figure, axes = plt.subplots(figsize=(10, 4.6))
    for key in results.keys():
        for threads in sorted({row["threads"] for row in results.scaling}):
            points = scaling_points(results, key, threads, value)
            if not points:
                continue
            exponent = fitted_exponent([(x, y) for x, y in scaling_points(results, key, threads, fitted or value)
                                        if x >= fitted_from])
            text = results.title(key) + (", %d threads" % threads if threads != 1 else "")
            if exponent is not None:
                text += "  n^%.2f" % exponent
            axes.plot([x for x, _ in points], [y for _, y in points], label=text, linewidth=1.2, markersize=5,
                      linestyle="-" if threads == 1 else "--", **_style(key))
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("points")
    axes.set_ylabel(label)
    axes.grid(which="major", color="#dddddd", linewidth=0.5)
    _legend(axes, loc="upper left", bbox_to_anchor=(1.01, 1.0))
    return _save(figure, folder, name)


def _histogram(results, folder):
    sums = {}
    with_original = {name for name, row in results.references.items() if row.get("triangles")}
    for row in list(results.references.values()) + results.all_rows:
        if with_original and row["model"] not in with_original:
            continue  # all curves are about the same models
        if row["status"] == "ok" and row.get("triangles") and row["threads"] <= 1 and "regularity_histogram" in row:
            counts = [n / row["triangles"] for n in row["regularity_histogram"]]
            sums.setdefault(row["method"], []).append(counts)
    figure, axes = plt.subplots(figsize=(8.5, 3.4))
    for key in ["reference"] + results.keys():
        if key in sums:
            means = [100 * sum(column) / len(column) for column in zip(*sums[key])]
            title = "original" if key == "reference" else results.title(key)
            style = {"color": "black", "marker": "."} if key == "reference" else _style(key)
            axes.plot([1.025 + 0.05 * i for i in range(10)], means, label=title, markersize=5, **style)
    axes.set_xlabel("regularity of a triangle (Eq. 3.1), 1.5 for equilateral ones")
    axes.set_ylabel("triangles (%), mean of models")
    axes.grid(color="#dddddd", linewidth=0.5)
    _legend(axes)
    return _save(figure, folder, "regularity")


def draw_all(results, folder):
    """Names and files of the plots."""
    plots = []
    for number, chapter, quantity in FIGURES:
        file = _comparison(results, folder, number, chapter, quantity)
        if file:
            plots.append(("Figure %s: %s" % (number, LABELS[quantity]), file))
    plots.append(("Regularity of the triangles", _histogram(results, folder)))
    if results.scaling:
        plots.append(("Time against the number of points (generated knot)", _scaling(
            results, folder, "scaling-time", "seconds (best run)", best)))
        # An empty process has some MB, which say nothing about the method.
        plots.append(("Memory against the number of points (generated knot); exponents are those of the memory above "
                      "the points, from 10,000 of them on", _scaling(
                          results, folder, "scaling-memory", "peak of the process (MB)",
                          lambda row: row["peak_bytes"] / 1e6, lambda row: row["growth_bytes"], 9000)))
    return plots
