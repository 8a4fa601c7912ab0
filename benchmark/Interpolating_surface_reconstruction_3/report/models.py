"""The models: generated ones, those of Debian's CGAL, and those of a folder."""

import csv
import os
import tarfile

HERE = os.path.dirname(os.path.abspath(__file__))
EXTENSIONS = (".ply", ".off", ".xyz")
SEED = 1


def read_csv(name):
    with open(os.path.join(HERE, name), newline="") as file:
        return list(csv.DictReader(file))


def generated(quick):
    shapes = ["sphere", "knot", "loop", "doubletorus", "boxes", "plates", "wedge"]
    sizes = {"sphere": 3000, "knot": 5000, "loop": 5000, "doubletorus": 5000, "boxes": 4000,
             "plates": 4000, "wedge": 3000}
    return [{"name": "generated-" + shape, "group": "generated",
             "source": "%s:%d:%d" % (shape, 1000 if quick else sizes[shape], SEED)} for shape in shapes]


def of_folder(folder, group):
    models = []
    for name in sorted(os.listdir(folder)):
        stem, extension = os.path.splitext(name)
        if extension.lower() in EXTENSIONS:
            models.append({"name": stem, "group": group, "source": os.path.join(folder, name)})
    return models


def of_debian(archive, folder, quick):
    """The models of the list that are in the archive of data of Debian's package libcgal-dev."""
    if not os.path.exists(archive):
        return []
    names = [row["file"] for row in read_csv("debian_models.csv") if row["quick"] == "yes" or not quick]
    os.makedirs(folder, exist_ok=True)
    missing = [name for name in names if not os.path.exists(os.path.join(folder, os.path.basename(name)))]
    if missing:
        with tarfile.open(archive) as tar:
            for member in tar:
                if member.isfile() and member.name in missing:
                    member.name = os.path.basename(member.name)
                    tar.extract(member, folder)
    wanted = {os.path.basename(name) for name in names}
    return [model for model in of_folder(folder, "debian") if os.path.basename(model["source"]) in wanted]


def all_models(folders, archive, work, quick, selection):
    models = generated(quick)
    for folder in folders:
        models += of_folder(folder, "folder")
    models += of_debian(archive, work, quick)
    unique = {}
    for model in models:
        unique.setdefault(model["name"], model)
    if selection:
        unknown = sorted(set(selection) - set(unique))
        if unknown:
            raise SystemExit("no such model: " + ", ".join(unknown))
        return [unique[name] for name in unique if name in selection]
    return list(unique.values())


def scaling_sizes(quick, largest):
    sizes = [500, 1000, 2000] if quick else [1000, 3000, 10000, 30000, 100000, 300000, 1000000]
    return [size for size in sizes if size <= largest]


def scaling_model(size):
    return {"name": "scaling-%d" % size, "group": "scaling", "source": "knot:%d:%d" % (size, SEED)}
