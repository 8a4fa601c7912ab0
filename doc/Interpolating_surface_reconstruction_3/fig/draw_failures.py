#!/usr/bin/python3
"""Draws the failures that the manual shows: draw_failures.py ISR_TABLES OUTPUT_FOLDER [NAME...]

ISR_TABLES is the program of the benchmark, see run_tables.sh there. The models are those of Debian's libcgal-dev;
each gets a picture of its original, of CTC, of LIS and of the advancing front, from the same place."""

import os
import subprocess
import sys
import tarfile
import tempfile

from PIL import Image

ARCHIVE = "/usr/share/doc/libcgal-dev/data.tar.gz"
MODELS = ["anchor", "spool", "oblong", "rotor_small", "cheese"]
METHODS = ["ctc", "lis", "af"]
PIXELS = 240


def extract(names, folder):
    wanted = {name + ".off" for name in names}
    with tarfile.open(ARCHIVE) as tar:
        for member in tar:
            if member.isfile() and os.path.basename(member.name) in wanted:
                member.name = os.path.basename(member.name)
                tar.extract(member, folder)


def draw(program, model, mesh, folder):
    picture = os.path.join(folder, "picture.ppm")
    subprocess.run([program, "measure", model, mesh, picture, str(PIXELS)], check=True, stdout=subprocess.DEVNULL)
    return Image.open(picture).convert("RGB")


def draw_model(program, model, folder):
    """The pictures of a model, one beside the other, with a palette so that the file is small."""
    panels = [draw(program, model, "-", folder)]
    mesh = os.path.join(folder, "mesh.ply")
    for method in METHODS:
        subprocess.run([program, "run", model, method, "1", "1", "0", mesh], check=True, stdout=subprocess.DEVNULL)
        panels.append(draw(program, model, mesh, folder))
    strip = Image.new("RGB", (PIXELS * len(panels), PIXELS), "white")
    for i, panel in enumerate(panels):
        strip.paste(panel, (PIXELS * i, 0))
    return strip.quantize(64, method=Image.MEDIANCUT, dither=Image.NONE)


def main():
    program, output = sys.argv[1:3]
    names = sys.argv[3:] or MODELS
    with tempfile.TemporaryDirectory() as folder:
        extract(names, folder)
        for name in names:
            strip = draw_model(program, os.path.join(folder, name + ".off"), folder)
            strip.save(os.path.join(output, "failure_%s.png" % name), optimize=True)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main()
