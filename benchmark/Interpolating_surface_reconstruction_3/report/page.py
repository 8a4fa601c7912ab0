"""One HTML page with everything in it."""

import base64
import html

from . import claims, thesis
from .models import read_csv
from .table import Table, number

STYLE = """
body { font: 15px/1.45 sans-serif; max-width: 1280px; margin: 0 auto; padding: 0 16px 60px; color: #222; }
h1 { margin-top: 28px; } h2 { margin-top: 44px; border-bottom: 1px solid #ccc; } h3 { margin: 26px 0 8px; }
table { border-collapse: collapse; font-size: 12.5px; } .scroll { overflow-x: auto; }
th, td { padding: 2px 7px; border-bottom: 1px solid #e4e4e4; text-align: right; white-space: nowrap; }
th:first-child, td:first-child, th:nth-child(2), td:nth-child(2) { text-align: left; }
td.bad { color: #a00; } td.words { text-align: left; white-space: normal; }
.note { font-size: 12.5px; color: #555; max-width: 900px; }
.strip { display: flex; flex-wrap: wrap; gap: 10px; } figure { margin: 0; width: 232px; }
figure img { width: 232px; border: 1px solid #ddd; } figcaption { font-size: 11.5px; color: #444; }
.none { width: 232px; height: 232px; border: 1px solid #ddd; background: #f6f0f0; }
.plot img { width: 100%; max-width: 860px; } nav a { margin-right: 14px; }
.holds { color: #0b6b2f; } .not { color: #a00; } .mid { color: #8a5a00; }
"""

COLOR_NOTE = ("Color is the distance of a triangle's barycenter to the true surface: gray none, yellow 0.25 %, red 1 % of "
              "the diagonal or more. Blue is the back of the surface, seen through holes or where triangles are turned "
              "the other way. All pictures of a row are seen from the same place. Points without a mesh have no colors.")


def _image(file, kind):
    with open(file, "rb") as source:
        return "data:image/%s;base64,%s" % (kind, base64.b64encode(source.read()).decode("ascii"))


def _verdict_class(verdict):
    return {"holds": "holds", "mostly holds": "holds", "does not hold": "not"}.get(verdict, "mid")


def _claims(results):
    rows = "".join(
        "<tr><td>%s</td><td class=words>%s</td><td class='%s'>%s</td><td class=words>%s</td></tr>\n" % (
            html.escape(section), html.escape(claim), _verdict_class(verdict), html.escape(verdict),
            html.escape(numbers))
        for section, claim, verdict, numbers in claims.answer(results))
    return ("<p class=note>%s</p><div class=scroll><table><tr><th>section</th><th>claim</th><th>verdict</th>"
            "<th>numbers</th></tr>%s</table></div>" % (html.escape(claims.RULE), rows))


def claims_markdown(results):
    lines = ["# The thesis's claims", "", claims.RULE, ""]
    for section, claim, verdict, numbers in claims.answer(results):
        lines.append("- **%s** (%s): **%s**. %s" % (claim, section, verdict, numbers))
    return "\n".join(lines) + "\n"


def models_table(results):
    rows = []
    same = {model["model"] for model in thesis.MODELS
            if thesis.is_same_mesh(model, results.references.get(model["model"]))}
    for model in results.models:
        reference = results.references.get(model["name"]) or {}
        kind = {"generated": "generated: " + model["source"], "debian": "Debian's libcgal-dev",
                "folder": "given folder"}[model["group"]]
        rows.append([model["name"], kind, number(reference.get("points")), number(reference.get("triangles")),
                     "yes" if model["name"] in same else None,
                     number(reference.get("boundary_edges")) if reference.get("triangles") else None,
                     number(reference.get("components")) if reference.get("triangles") else None,
                     reference.get("euler") if reference.get("triangles") else None])
    return Table("models", "Models of this run",
                 ["model", "source", "points", "triangles", "thesis's mesh", "boundary edges", "components", "Euler"],
                 rows, "'thesis's mesh': vertices and triangles are as many as the thesis prints for that name. "
                 "Generated models are SHAPE:POINTS:SEED; their true surface is exact.")


def originals_table():
    rows = [[row["model"], row["collection"], number(row["vertices"]), number(row["triangles"]), row["address"]]
            for row in read_csv("originals.csv")]
    return Table("originals", "Where the thesis's models can be had",
                 ["model", "collection", "vertices", "triangles", "address"], rows,
                 "The thesis names five collections, not which model is from which (Princeton Shape Benchmark, 3D Segmentation "
                 "Benchmark, tf3dm, the pages of John Burkardt, MeshLab); counts are those it prints. Put the files into a "
                 "folder as duck.ply, knot.ply and so on, and give it with --models.")


def _pictures(rows, texts):
    parts = ["<p class=note>%s</p>" % html.escape(COLOR_NOTE)]
    for name, pictures in rows:
        parts.append("<h3>%s</h3>" % html.escape(name))
        parts += ["<p>%s</p>" % html.escape(text) for text in texts.get(name, [])]
        parts.append("<div class=strip>")
        for title, caption, file in pictures:
            image = "<img src='%s' alt='%s'>" % (_image(file, "jpeg"), html.escape(title)) if file \
                else "<div class=none></div>"
            parts.append("<figure>%s<figcaption><b>%s</b>: %s</figcaption></figure>" % (
                image, html.escape(title), html.escape(caption)))
        parts.append("</div>")
    return "\n".join(parts)


def write(file, results, tables, thesis_tables, plots, picture_rows, texts):
    environment = "".join("<li>%s: %s</li>" % (html.escape(key), html.escape(str(value)))
                          for key, value in results.environment.items())
    methods = "".join("<li><b>%s</b> (<code>%s</code>): %s</li>" % (
        html.escape(method["title"]), method["key"], html.escape(method["description"]))
        for method in results.methods)
    missing = [thesis.TITLES[key] for key in ("pcr", "ctc", "ctc-thesis", "lis", "lis-thesis", "af", "power-crust",
                                              "scale-space", "poisson") if not results.has(key)]
    if missing:
        methods += "<li>Not among the methods of this run: %s.</li>" % html.escape(", ".join(missing))
    plot_parts = "".join("<h3>%s</h3><div class=plot><img src='%s' alt=''></div>" % (
        html.escape(title), _image(name, "svg+xml")) for title, name in plots)
    by_name = {table.name: table for table in tables}
    sections = [
        ("summary", "Summary", by_name["summary"].html()),
        ("claims", "The thesis's claims", _claims(results)),
        ("models", "Models", models_table(results).html() + originals_table().html()),
        ("methods", "Methods", "<ul>%s</ul>" % methods),
        ("thesis", "The thesis's tables", "".join(table.html() for table in thesis_tables)),
        ("figures", "Figures", "<p class=note>A star marks the thesis's own mesh. Figures have the number of the "
         "thesis's figure that shows the same quantity.</p>" + plot_parts),
        ("pictures", "Pictures", _pictures(picture_rows, texts)),
        ("all", "Everything measured", by_name["measures"].html() + by_name["times"].html()
         + by_name["scaling"].html() + by_name["regularity"].html())]
    navigation = "".join("<a href='#%s'>%s</a>" % (key, title) for key, title, _ in sections)
    body = "".join("<h2 id='%s'>%s</h2>\n%s\n" % section for section in sections)
    with open(file, "w", encoding="utf-8") as out:
        out.write("""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Surface reconstruction: tables and figures</title>
<style>%s</style></head><body>
<h1>Surface reconstruction: the thesis's tables and figures, run again</h1>
<p>Every method got the same points: the vertices of a mesh, random points of an exact surface, or a scan. What it made
of them is compared with the mesh or surface the points come from. Each job ran in a process of its own with a limit of
time and memory; a method that failed has a row that says how. Nothing on this page is typed in but the thesis's own
numbers, which are marked as such, and remarks on pictures, which appear only while the numbers they rest on are
measured again.</p>
<nav>%s</nav><ul class=note>%s</ul>
%s
</body></html>
""" % (STYLE, navigation, environment, body))
