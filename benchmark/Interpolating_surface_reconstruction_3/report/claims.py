"""The thesis's claims, each answered with the numbers of the run."""

from . import thesis
from .results import is_closed, ratio_to_front
from .table import number

INTERPOLATING = ["ctc", "ctc-thesis", "pcr", "af"]
APPROXIMATING = ["scale-space", "poisson"]

RULE = ("Verdicts follow one rule: a claim 'holds' if it does in all comparisons, 'mostly holds' in at least two "
        "thirds, 'does not hold' in at most one third, else it is 'undecided'. Comparisons are on models with an "
        "original mesh; equal values support a claim of 'not above'. Times are "
        "compared as multiples of the advancing front's, which ran in turn with every method.")


def _verdict(good, total):
    if total == 0:
        return "not tested"
    if good == total:
        return "holds"
    return "mostly holds" if 3 * good >= 2 * total else "does not hold" if 3 * good <= total else "undecided"


class Judge:
    def __init__(self, results):
        self.results = results
        self.names = [model["name"] for model in results.models
                      if results.references.get(model["name"], {}).get("triangles")]

    def value(self, name, key, quantity):
        row = self.results.ok(name, key)
        if row is None:
            return None
        if quantity == "seconds":  # in those of the advancing front, which ran in turn with the method
            ratio = 1.0 if key == "af" else ratio_to_front(row)
            return 1.0 / ratio if ratio else None
        return row.get(quantity)

    def count(self, first, others, quantity, margin=1.0):
        """How often `first` is not above margin times another method, and of how many comparisons."""
        good = total = 0
        for name in self.names:
            a = self.value(name, first, quantity)
            for other in others:
                b = self.value(name, other, quantity)
                if other != first and a is not None and b is not None:
                    total += 1
                    good += a <= margin * b * (1 + 1e-9) + 1e-12
        return good, total

    def not_above(self, firsts, others, quantity):
        """A verdict on several methods against several others, with the counts of each."""
        parts, all_good, all_total = [], 0, 0
        for first in firsts:
            if not self.results.has(first):
                parts.append("%s was not run" % thesis.TITLES[first])
                continue
            good, total = self.count(first, others, quantity)
            parts.append("%s: %d of %d" % (self.results.title(first), good, total))
            all_good += good
            all_total += total
        return _verdict(all_good, all_total), "; ".join(parts)

    def fraction(self, keys, test, concerns=lambda ref: True):
        """A verdict on a property of the meshes of some methods, on the models whose original it concerns."""
        parts, all_good, all_total = [], 0, 0
        for key in keys:
            rows = [(name, self.results.ok(name, key)) for name in self.names]
            rows = [(name, row) for name, row in rows if row is not None and concerns(self.results.references[name])]
            if not self.results.has(key):
                parts.append("%s was not run" % thesis.TITLES[key])
                continue
            good = sum(bool(test(row, self.results.references[name])) for name, row in rows)
            parts.append("%s: %d of %d models" % (self.results.title(key), good, len(rows)))
            all_good += good
            all_total += len(rows)
        return _verdict(all_good, all_total), "; ".join(parts)


def _median_difference(judge, key):
    values = sorted(abs(row["triangles"] - judge.results.references[name]["triangles"])
                    / judge.results.references[name]["triangles"]
                    for name in judge.names for row in [judge.results.ok(name, key)] if row is not None)
    return values[len(values) // 2] if values else None


def _triangle_counts(judge):
    words, good, total = [], 0, 0
    for key in INTERPOLATING + ["power-crust"] + APPROXIMATING:
        difference = _median_difference(judge, key)
        if difference is not None:
            words.append("%s %.2f %%" % (judge.results.title(key), 100 * difference))
            total += 1
            good += (difference < 0.01) == (key in INTERPOLATING)
    return _verdict(good, total), "median difference to the original: " + ", ".join(words)


def _open_bases(judge):
    words, good, total = [], 0, 0
    for name in ("maxplanck", "bunny"):
        for key in ("pcr", "ctc"):
            row = judge.results.ok(name, key) if name in judge.names else None
            if row is not None:
                total += 1
                good += is_closed(row) and judge.results.references[name]["boundary_edges"] > 0
                words.append("%s on %s: %d of the %d boundary edges stay, H %.2f %%" % (
                    judge.results.title(key), name, row["boundary_edges"],
                    judge.results.references[name]["boundary_edges"], row["thesis_hausdorff"]))
    return _verdict(good, total), "; ".join(words)


def _lis_triangles(judge):
    """The verdict is on the thesis's grid; LIS through the samples is told beside it."""
    others = [key for key in ("ctc", "pcr", "af") if judge.results.has(key)]
    counts = {}
    for key in ("lis-thesis", "lis"):
        good = total = 0
        for name in judge.names:
            triangles = judge.value(name, key, "triangles")
            found = [judge.value(name, other, "triangles") for other in others]
            found.append(judge.results.references[name]["triangles"])
            for count in found:
                if triangles is not None and count is not None:
                    total += 1
                    good += triangles > 1.5 * count
        counts[key] = good, total
    return _verdict(*counts["lis-thesis"]), "more than 1.5 times as many: " + "; ".join(
        "%s in %d of %d comparisons" % ((judge.results.title(key),) + count) for key, count in counts.items())


def _fish(judge):
    row = judge.results.row("fish", "power-crust")
    if row is None:
        return "not tested", "no fish, or no power crust, in this run"
    if row["status"] != "ok":
        return "holds", "our power crust: %s %s" % (row["status"], row["message"])
    return "does not hold", ("our power crust gives %s triangles on another fish, H %.3f %%: the failure is not one "
                             "of the method" % (number(row["triangles"]), row.get("thesis_hausdorff", 0)))


def answer(results):
    """Claims as section, claim, verdict and numbers."""
    judge = Judge(results)
    rivals3 = ["af", "power-crust", "scale-space", "poisson"]
    every = INTERPOLATING + ["power-crust"] + APPROXIMATING
    claims = [
        ("3.4.4, 4.4.4", "PCR, CTC and advancing front keep the number of vertices.",
         judge.fraction(INTERPOLATING, lambda row, ref: row["points_used"] == row["distinct_points"]
                        and row["interpolates"])),
        ("3.4.4", "So does scale space.",
         judge.fraction(["scale-space"], lambda row, ref: row["points_used"] == row["distinct_points"]
                        and row["interpolates"])),
        ("3.4.4, 4.4.4", "Their number of triangles is nearly that of the original, others' is not.",
         _triangle_counts(judge)),
        ("3.4.4", "H of PCR is in general smaller than that of the other methods.",
         judge.not_above(["pcr"], rivals3, "thesis_hausdorff")),
        ("4.4.4", "H of CTC is in general smaller than that of the other methods.",
         judge.not_above(["ctc", "ctc-thesis"], rivals3, "thesis_hausdorff")),
        ("3.4.4, 4.4.4", "Implicit methods are farther from the original than simplicial ones (mean).",
         judge.not_above(INTERPOLATING, APPROXIMATING, "thesis_mean")),
        ("3.4.4", "PCR is closest in RMS.", judge.not_above(["pcr"], every, "thesis_rms")),
        ("3.4.4, 4.4.4", "CTC and PCR have the lowest dispersion (SD) for all models.",
         judge.not_above(["ctc", "pcr"], ["af", "power-crust"] + APPROXIMATING, "thesis_sd")),
        ("4.4.4", "CTC and PCR are first in RMS.",
         judge.not_above(["ctc", "pcr"], ["af", "power-crust"] + APPROXIMATING, "thesis_rms")),
        ("3.4.5", "PCR is the fastest.", judge.not_above(["pcr"], rivals3, "seconds")),
        ("4.4.5", "CTC is faster than advancing front, scale space, power crust and Poisson.",
         judge.not_above(["ctc", "ctc-thesis"], rivals3, "seconds")),
        ("3.4.5, 4.4.5", "Power crust is slower than the simplicial methods.",
         judge.not_above(INTERPOLATING, ["power-crust"], "seconds")),
        ("3.5, 4.5", "Power crust cannot reconstruct the fish.", _fish(judge)),
        ("3.5, 4.5", "H is large on MaxPlanck and Bunny because their open bases are closed.", _open_bases(judge)),
        ("3.5.1, 4.5.1", "PCR and CTC do not suffer from mesh drifting (right genus and components).",
         judge.fraction(["pcr", "ctc", "ctc-thesis"], lambda row, ref: row["components"] == ref["components"]
                        and row["euler"] + row["boundary_loops"] == ref["euler"] + ref["boundary_loops"])),
        ("3.6, 4.6", "The triangles are quasi-regular: as regular as the original's (mean of Eq. 3.1 within 1 %).",
         judge.fraction(["pcr", "ctc", "ctc-thesis"],
                        lambda row, ref: row["regularity_mean"] >= 0.99 * ref["regularity_mean"])),
        ("5.4.4", "LIS has many more triangles than the original and the simplicial methods.", _lis_triangles(judge)),
        ("5.4.4", "H of LIS is much lower than that of Poisson and scale space.",
         judge.not_above(["lis", "lis-thesis"], APPROXIMATING, "thesis_hausdorff")),
        ("5.4.4", "LIS keeps open surfaces open.",
         judge.fraction(["lis", "lis-thesis"], lambda row, ref: row["boundary_edges"] > 0,
                        lambda ref: ref["boundary_edges"] > 0)),
    ]
    return [(section, claim, verdict, numbers) for section, claim, (verdict, numbers) in claims]
