"""What the thesis prints: its models, and the numbers of its tables 3.1 to 5.2."""

from .models import read_csv

# Methods in the order of the thesis's figures, with our variants beside their originals.
CHAPTER_METHODS = {
    3: ["pcr", "power-crust", "af", "scale-space", "poisson"],
    4: ["ctc", "ctc-thesis", "pcr", "power-crust", "af", "scale-space", "poisson"],
    5: ["lis", "lis-thesis", "ctc", "pcr", "power-crust", "af", "scale-space", "poisson"],
}

# Tables with vertices, triangles and H, and with triangles and H.
MESH_TABLES = [
    ("3.1", ["pcr", "af"], True), ("3.2", ["power-crust", "scale-space", "poisson"], True),
    ("4.1", ["ctc", "pcr"], True), ("4.2", ["af", "power-crust"], True),
    ("4.3", ["scale-space", "poisson"], True), ("5.1", ["lis", "ctc", "pcr"], False),
    ("5.2", ["af", "power-crust", "scale-space", "poisson"], False)]
TIME_TABLES = [("3.3", ["pcr", "af", "scale-space", "power-crust", "poisson"]),
               ("4.4", ["ctc", "pcr", "af", "scale-space", "power-crust", "poisson"])]

TITLES = {"ctc": "CTC", "ctc-thesis": "CTC, thesis's stars", "pcr": "PCR", "lis": "LIS",
          "lis-thesis": "LIS, thesis's weights", "af": "Advancing front", "power-crust": "Power crust",
          "scale-space": "Scale space", "poisson": "Poisson"}

MODELS = read_csv("thesis_models.csv")
_VALUES = {(row["table"], row["method"], row["model"]): row for row in read_csv("thesis_values.csv")}


def value(table, method, model, quantity):
    """A number that the thesis prints, as a word, or nothing."""
    return _VALUES.get((table, method, model), {}).get(quantity, "")


def is_same_mesh(model, reference):
    """Whether a mesh has the counts of the thesis's mesh of that name."""
    return (reference is not None and str(reference.get("points")) == model["vertices"]
            and str(reference.get("triangles")) == model["triangles"])
