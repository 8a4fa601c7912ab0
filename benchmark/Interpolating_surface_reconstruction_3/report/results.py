"""The rows of a run, and how to ask for them."""

import math


class Results:
    def __init__(self, methods, models, rows, references, scaling, environment, largest_of_peers):
        self.methods = methods
        self.models = models
        self.references = references  # by name of the model
        self.scaling = scaling
        self.environment = environment
        self.largest_of_peers = largest_of_peers
        self.all_rows = rows
        self._rows = {(row["model"], row["method"], row["threads"]): row for row in rows}

    def row(self, model, method, threads=1):
        return self._rows.get((model, method, threads))

    def ok(self, model, method, threads=1):
        """The row of a method that gave a mesh, or nothing."""
        row = self.row(model, method, threads)
        return row if row is not None and row["status"] == "ok" and row.get("triangles") else None

    def title(self, key):
        for method in self.methods:
            if method["key"] == key:
                return method["title"]
        return key

    def keys(self):
        return [method["key"] for method in self.methods]

    def has(self, key):
        return key in self.keys()


def is_run(method, reference, largest_of_peers):
    """Whether a method is run on the model: peers, but for the advancing front, only on models of so many points."""
    return method["is_ours"] or method["key"] == "af" or reference.get("points", 0) <= largest_of_peers


def best(row, key="seconds"):
    values = (row or {}).get(key)
    return min(values) if values else None


def median(row, key="seconds"):
    values = sorted((row or {}).get(key) or [])
    return values[len(values) // 2] if values else None


def ratio_to_front(row):
    """Time of the advancing front over the time of the method, both from runs in turn."""
    ours, front = best(row), best(row, "baseline_seconds")
    return front / ours if ours and front else None


def geometric_mean(values):
    values = [value for value in values if value]
    return math.exp(sum(math.log(value) for value in values) / len(values)) if values else None


def is_manifold(row):
    return row["nonmanifold_edges"] == 0 and row["nonmanifold_vertices"] == 0


def is_closed(row):
    return row["triangles"] > 0 and row["boundary_edges"] == 0


def expected_topology(reference, row):
    """Components, Euler characteristic and boundary loops of the true surface, if they are known."""
    if "true_euler" in row:
        return row["true_components"], row["true_euler"], 0
    if reference is None or not reference.get("triangles"):
        return None
    if not is_manifold(reference):
        return None
    return reference["components"], reference["euler"], reference["boundary_loops"]


def has_right_topology(reference, row):
    """None if the true one is not known. Discs in all holes of an open surface count as right."""
    expected = expected_topology(reference, row)
    if expected is None:
        return None
    components, euler, loops = expected
    if not is_manifold(row) or row["components"] != components:
        return False
    if is_closed(row):
        return row["euler"] == euler + loops
    return row["boundary_loops"] == loops and row["euler"] == euler
