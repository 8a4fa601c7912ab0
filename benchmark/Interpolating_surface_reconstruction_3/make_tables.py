#!/usr/bin/python3
"""Runs all methods on all models, and makes tables, plots, pictures and a page; see run_tables.sh."""

import argparse
import datetime
import math
import os
import platform
import sys
import time

from report import check, page, pictures, plots, tables, thesis_tables
from report.jobs import Limits, Runner, list_methods
from report.models import all_models, scaling_model, scaling_sizes
from report.results import Results, best, is_run

DEBIAN_ARCHIVE = "/usr/share/doc/libcgal-dev/data.tar.gz"

# On the one large model, the slow peers would take a third of the time of a quick run.
QUICK_LARGEST_OF_PEERS = 10000


def parse_arguments():
    parser = argparse.ArgumentParser(prog="run_tables.sh", description=__doc__.split(";")[0] + ".")
    parser.add_argument("--program", required=True, help=argparse.SUPPRESS)
    parser.add_argument("--output", default="tables", metavar="DIR", help="folder of the results (default: tables)")
    parser.add_argument("--models", action="append", default=[], metavar="DIR",
                        help="folder of .ply, .off or .xyz models, as duck.ply, bunny.ply; may be repeated")
    parser.add_argument("--only", default="", metavar="NAME,...", help="run these models only")
    parser.add_argument("--methods", default="", metavar="KEY,...", help="run these methods only (default: all)")
    parser.add_argument("--runs", type=int, default=3, help="runs of a method on a model (default: 3)")
    parser.add_argument("--threads", default="1,2", metavar="N,...", help="numbers of threads (default: 1,2)")
    parser.add_argument("--time-limit", type=float, default=600, metavar="SECONDS", help="of a job (default: 600)")
    parser.add_argument("--memory-limit", type=int, default=0, metavar="MB",
                        help="of a job (default: three quarters of the machine's)")
    parser.add_argument("--largest", type=int, default=1000000, metavar="POINTS",
                        help="largest model of the plots against the number of points (default: 1000000)")
    parser.add_argument("--pixels", type=int, default=320, help="size of the pictures (default: 320)")
    parser.add_argument("--retry", action="store_true", help="run jobs again that failed before")
    parser.add_argument("--report", action="store_true", help="run nothing: report on the jobs run so far")
    parser.add_argument("--quick", action="store_true", help="small models and two runs: about two minutes")
    parser.add_argument("--check", action="store_true", help="check that the results are complete")
    arguments = parser.parse_args()
    arguments.largest_of_peers = QUICK_LARGEST_OF_PEERS if arguments.quick else math.inf
    if arguments.quick:
        arguments.runs = 2
        arguments.time_limit = min(arguments.time_limit, 60)
    if arguments.memory_limit == 0:
        memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
        arguments.memory_limit = memory * 3 // 4 >> 20
    arguments.threads = sorted({int(word) for word in arguments.threads.split(",")})
    return arguments


def choose_methods(program, selection):
    methods = sorted(list_methods(program), key=lambda method: (not method["is_ours"], method["key"]))
    if not selection:
        return methods
    words = selection.split(",")
    unknown = sorted(set(words) - {method["key"] for method in methods})
    if unknown:
        raise SystemExit("no such method: %s (there are %s)" % (
            ", ".join(unknown), ", ".join(method["key"] for method in methods)))
    return [method for method in methods if method["key"] in words]


class Progress:
    def __init__(self, total):
        self.total, self.done, self.fresh, self.begin = total, 0, 0, time.time()

    def report(self, row, is_new):
        self.done += 1
        self.fresh += is_new
        outcome = row["status"] if row["status"] != "ok" else "%.3f s" % best(row)
        text = "[%d/%d] %s, %s, %d thread%s: %s%s" % (
            self.done, self.total, row["model"], row["method"], row["threads"], "s" if row["threads"] > 1 else "",
            outcome, "" if is_new else " (there already)")
        if self.fresh:
            rest = (time.time() - self.begin) / self.fresh * (self.total - self.done)
            text += ", about %d:%02d left" % (rest // 60, rest % 60)
        print(text, flush=True)


def thread_counts(method, threads):
    """One thread is always measured: the tables are about it."""
    return sorted({1} | set(threads)) if method["uses_threads"] else [1]


def run_models(runner, models, methods, threads, largest_of_peers, progress):
    rows, references = [], {}
    for model in models:
        reference = runner.reference(model)
        if reference is None:
            continue
        references[model["name"]] = reference
        for method in methods:
            for count in thread_counts(method, threads):
                if not is_run(method, reference, largest_of_peers):
                    progress.done += 1
                    continue
                row, is_new = runner.row(model, method, count)
                if row is not None:
                    rows.append(row)
                    progress.report(row, is_new)
    return rows, references


def run_scaling(runner, sizes, methods, threads, progress):
    rows, stopped = [], set()
    for size in sizes:
        for method in methods:
            for count in thread_counts(method, threads):
                if (method["key"], count) in stopped:
                    progress.done += 1
                    continue
                row, is_new = runner.row(scaling_model(size), method, count, measured=False)
                if row is None:
                    continue
                rows.append(row)
                progress.report(row, is_new)
                if row["status"] != "ok":  # larger ones would fail as well
                    stopped.add((method["key"], count))
    return rows


def environment(arguments):
    with open("/proc/cpuinfo") as file:
        names = [line.split(":", 1)[1].strip() for line in file if line.startswith("model name")]
    return {"date": datetime.date.today().isoformat(), "processor": names[0] if names else platform.machine(),
            "processors": os.cpu_count(), "system": platform.platform(),
            "limits of a job": "%g s, %d MB" % (arguments.time_limit, arguments.memory_limit),
            "runs of a job": arguments.runs, "threads": ", ".join(map(str, arguments.threads)),
            "mode": "quick" if arguments.quick else "full"}


def write_report(results, output):
    table_folder, plot_folder = os.path.join(output, "tables"), os.path.join(output, "plots")
    for folder in (table_folder, plot_folder):
        os.makedirs(folder, exist_ok=True)
    own_tables = [tables.summary(results), tables.measures(results), tables.absolute(results), tables.times(results),
                  tables.scaling(results), tables.regularity(results)]
    of_thesis = thesis_tables.all_tables(results)
    for table in own_tables + of_thesis + [page.models_table(results), page.originals_table()]:
        table.write(table_folder)
    with open(os.path.join(table_folder, "claims.md"), "w") as file:
        file.write(page.claims_markdown(results))
    page.write(os.path.join(output, "index.html"), results, own_tables, of_thesis,
               plots.draw_all(results, plot_folder), pictures.picture_rows(results, output),
               pictures.observations(results))


def main():
    arguments = parse_arguments()
    methods = choose_methods(arguments.program, arguments.methods)
    models = all_models(arguments.models, DEBIAN_ARCHIVE, os.path.join(arguments.output, "models"), arguments.quick,
                        [word for word in arguments.only.split(",") if word])
    sizes = scaling_sizes(arguments.quick, arguments.largest)
    runner = Runner(arguments.program, arguments.output, Limits(arguments.time_limit, arguments.memory_limit),
                    arguments.runs, arguments.pixels, arguments.retry, arguments.report)
    jobs = (len(models) + len(sizes)) * sum(len(thread_counts(method, arguments.threads)) for method in methods)
    print("%d models, %d methods, %d jobs; interrupt and run again to resume" % (len(models), len(methods), jobs),
          flush=True)
    progress = Progress(jobs)
    rows, references = run_models(runner, models, methods, arguments.threads, arguments.largest_of_peers, progress)
    scaling = run_scaling(runner, sizes, methods, arguments.threads, progress)
    measured = [model for model in models if model["name"] in references]
    results = Results(methods, measured, rows, references, scaling, environment(arguments), arguments.largest_of_peers)
    write_report(results, arguments.output)
    print("The report is %s" % os.path.abspath(os.path.join(arguments.output, "index.html")))
    if arguments.check:
        check.check(results, arguments.output)


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit("interrupted; the same command goes on from here")
