"""Tables 3.1 to 5.2 of the thesis, in its form, its numbers beside ours where the mesh is the same."""

from . import thesis
from .results import best, ratio_to_front
from .table import Table, number

CAPTIONS = {
    "3.1": "Original meshes and meshes by PCR and advancing front",
    "3.2": "Meshes by power crust, scale space and Poisson",
    "3.3": "Times in seconds",
    "4.1": "Original meshes and meshes by CTC and PCR",
    "4.2": "Meshes by advancing front and power crust",
    "4.3": "Meshes by scale space and Poisson",
    "4.4": "Times in seconds",
    "5.1": "Original meshes and meshes by LIS, CTC and PCR",
    "5.2": "Meshes by advancing front, power crust, scale space and Poisson"}

NOTE = ("Columns '(thesis)' are the numbers that the thesis prints, given where our file has as many vertices and "
        "triangles as its mesh; other models are of the same name only, and their numbers must not be compared. Our "
        "H is in % of the diagonal; the unit of the thesis's H is not known, so compare ratios between methods.")
TIME_NOTE = ("The thesis's seconds are of another machine: compare ratios between methods. Poisson: with the time to "
             "estimate and orient normals. " + NOTE.split(". Our")[0] + ".")


def thesis_models(results):
    """The thesis's models in its order with our model of the name, and whether it is the same mesh."""
    names = {model["name"] for model in results.models}
    return [(model, results.references.get(model["model"]) if model["model"] in names else None,
             thesis.is_same_mesh(model, results.references.get(model["model"])))
            for model in thesis.MODELS if model["model"] in names]


def _original(model, reference, is_same):
    name = model["label"] if is_same else model["label"] + " (not the thesis's)"
    return [model["number"], name, number(reference["points"]), number(reference["triangles"])]


def _failure(results, name, key):
    row = results.row(name, key)
    return "not run" if row is None else None if row["status"] == "ok" else "failed: " + row["status"]


def _printed(table, key, model, quantity, is_same):
    value = thesis.value(table, key, model["model"], quantity) if is_same else ""
    return number(value) if value and quantity in ("vertices", "triangles") else value or None


def mesh_table(results, table, keys, with_vertices):
    quantities = ["vertices", "triangles", "hausdorff"] if with_vertices else ["triangles", "hausdorff"]
    words = {"vertices": "V", "triangles": "T", "hausdorff": "H"}
    columns = ["", "model", "V", "T"]
    for key in keys:
        for quantity in quantities:
            columns += ["%s %s" % (thesis.TITLES[key], words[quantity]), "(thesis)"]
    rows = []
    for model, reference, is_same in thesis_models(results):
        cells = _original(model, reference, is_same)
        for key in keys:
            row = results.ok(model["model"], key)
            ours = {} if row is None else {"vertices": number(row["vertices"]), "triangles": number(row["triangles"]),
                                           "hausdorff": number(row.get("thesis_hausdorff"), 3)}
            for quantity in quantities:
                cells += [ours.get(quantity, _failure(results, model["model"], key)),
                          _printed(table, key, model, quantity, is_same)]
        rows.append(cells)
    return Table("table-" + table.replace(".", "-"), "Table %s: %s" % (table, CAPTIONS[table]), columns, rows, NOTE)


def time_table(results, table, keys):
    columns = ["", "model", "V", "T"]
    for key in keys:
        columns += [thesis.TITLES[key], "(thesis)"]
    rows = []
    for model, reference, is_same in thesis_models(results):
        cells = _original(model, reference, is_same)
        for key in keys:
            row = results.ok(model["model"], key)
            cells += [number(best(row), 3) if row else _failure(results, model["model"], key),
                      _printed(table, key, model, "seconds", is_same)]
        rows.append(cells)
    return Table("table-" + table.replace(".", "-"), "Table %s: %s" % (table, CAPTIONS[table]), columns, rows,
                 TIME_NOTE)


def _ratio(value, base):
    """Of two numbers or words; nothing without both or over zero."""
    return number(float(value) / float(base), 2) if value not in (None, "") and base and float(base) else None


def ratio_table(results):
    """H and time in those of the advancing front, ours and the thesis's, where the mesh is the thesis's."""
    keys = [key for key in thesis.CHAPTER_METHODS[5] if key != "af" and results.has(key)]
    columns = ["", "model"]
    for key in keys:
        columns += [thesis.TITLES[key] + " H", "(thesis)", "time", "(thesis)"]
    rows = []
    for model, _, is_same in thesis_models(results):
        front = results.ok(model["model"], "af")
        if not is_same or front is None:
            continue
        cells = [model["number"], model["label"]]
        for key in keys:
            row = results.ok(model["model"], key) or {}
            printed = {}
            for table in ("5.1", "4.1", "3.1", "3.2", "4.4"):
                for quantity in ("hausdorff", "seconds"):
                    printed.setdefault(quantity, "")
                    printed[quantity] = printed[quantity] or thesis.value(table, key, model["model"], quantity)
            ratio = ratio_to_front(row)
            cells += [_ratio(row.get("thesis_hausdorff"), front["thesis_hausdorff"]),
                      _ratio(printed["hausdorff"], thesis.value("3.1", "af", model["model"], "hausdorff")),
                      number(1 / ratio, 2) if ratio else None,
                      _ratio(printed["seconds"], thesis.value("4.4", "af", model["model"], "seconds"))]
        rows.append(cells)
    return Table("ratios", "H and time over those of the advancing front, on the thesis's own meshes", columns, rows,
                 "Less than 1 is nearer or faster than the advancing front. These ratios can be compared with the "
                 "thesis's, though unit and machine differ. No ratio where the advancing front's H is 0.")


def all_tables(results):
    tables = [mesh_table(results, *description) for description in thesis.MESH_TABLES]
    tables += [time_table(results, *description) for description in thesis.TIME_TABLES]
    return sorted(tables, key=lambda table: table.name) + [ratio_table(results)]
