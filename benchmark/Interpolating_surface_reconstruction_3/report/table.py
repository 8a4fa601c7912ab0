"""A table that can be written as CSV, Markdown, LaTeX and HTML."""

import csv
import html
import os


class Table:
    def __init__(self, name, title, columns, rows, note=""):
        self.name = name        # of its files
        self.title = title
        self.columns = columns
        self.rows = rows        # words; None is a cell without a value
        self.note = note

    def _words(self, row):
        return ["–" if cell is None or cell == "" else str(cell) for cell in row]

    def csv(self, file):
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(self.columns)
        for row in self.rows:
            writer.writerow(["" if cell is None else str(cell).replace(",", "") for cell in row])

    def markdown(self):
        lines = ["### " + self.title, ""]
        lines.append("| " + " | ".join(self.columns) + " |")
        lines.append("|" + "|".join(" --- " if i < 2 else " ---: " for i in range(len(self.columns))) + "|")
        for row in self.rows:
            lines.append("| " + " | ".join(self._words(row)) + " |")
        if self.note:
            lines += ["", self.note]
        return "\n".join(lines) + "\n"

    def latex(self):
        def escape(text):
            for a, b in (("\\", r"\textbackslash{}"), ("%", r"\%"), ("#", r"\#"), ("&", r"\&"),
                         ("_", r"\_"), ("–", "--")):
                text = text.replace(a, b)
            return text
        lines = [r"\begin{table}", r"\centering\footnotesize", r"\caption{%s}" % escape(self.title),
                 r"\begin{tabular}{%s}" % ("ll" + "r" * (len(self.columns) - 2)), r"\hline",
                 " & ".join(escape(column) for column in self.columns) + r" \\", r"\hline"]
        lines += [" & ".join(escape(word) for word in self._words(row)) + r" \\" for row in self.rows]
        lines += [r"\hline", r"\end{tabular}"]
        if self.note:
            lines.append(r"\par " + escape(self.note))
        return "\n".join(lines + [r"\end{table}"]) + "\n"

    def html(self):
        head = "".join("<th>%s</th>" % html.escape(column) for column in self.columns)
        body = ""
        for row in self.rows:
            cells = ""
            for i, word in enumerate(self._words(row)):
                bad = ' class="bad"' if word.startswith("failed") else ""
                cells += "<td%s>%s</td>" % (bad, html.escape(word))
            body += "<tr>%s</tr>\n" % cells
        note = "<p class=note>%s</p>" % html.escape(self.note) if self.note else ""
        return ("<h3 id='%s'>%s</h3><div class=scroll><table><thead><tr>%s</tr></thead><tbody>\n%s</tbody>"
                "</table></div>%s\n" % (self.name, html.escape(self.title), head, body, note))

    def write(self, folder):
        with open(os.path.join(folder, self.name + ".csv"), "w", newline="") as file:
            self.csv(file)
        with open(os.path.join(folder, self.name + ".md"), "w") as file:
            file.write(self.markdown())
        with open(os.path.join(folder, self.name + ".tex"), "w") as file:
            file.write(self.latex())


def number(value, digits=None):
    """Words of a number: counts with separators, others with so many digits after the point."""
    if value is None or value == "":
        return None
    if digits is None:
        return "{:,}".format(int(value))
    return "{:.{}f}".format(float(value), digits)
