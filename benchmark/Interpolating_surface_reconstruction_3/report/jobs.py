"""Runs isr_tables, each job in a process of its own with limits of time and memory."""

import json
import os
import resource
import signal
import subprocess
import time


class Limits:
    def __init__(self, seconds, megabytes):
        self.seconds = seconds
        self.megabytes = megabytes


def _typed(value):
    for kind in (int, float):
        try:
            return kind(value)
        except ValueError:
            pass
    return value


def _values(text):
    """The lines "key<TAB>value" of a job; keys of lists have lists."""
    values = {}
    for line in text.splitlines():
        key, _, value = line.partition("\t")
        if key.endswith("seconds") and key != "normal_seconds" or key.endswith("histogram"):
            values[key] = [_typed(word) for word in value.split()]
        else:
            values[key] = _typed(value)
    return values


def _failure(process, error, limits):
    """What a process that did not succeed died of."""
    code = process.returncode
    message = error.strip().splitlines()[-1] if error.strip() else ""
    if "bad_alloc" in error or "Cannot allocate memory" in error:
        return "memory limit", "more than %d MB" % limits.megabytes
    if code < 0 or code > 128:
        number = -code if code < 0 else code - 128
        return "crash", "%s %s" % (signal.Signals(number).name, message[:200])
    return "error", message[:200]


def run_process(command, limits):
    """Status, message and values of a job."""
    def limit_memory():
        size = limits.megabytes << 20
        resource.setrlimit(resource.RLIMIT_AS, (size, size))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True, errors="replace",
                               preexec_fn=limit_memory)
    try:
        output, error = process.communicate(timeout=limits.seconds)
    except subprocess.TimeoutExpired:
        process.kill()
        values = _values(process.communicate()[0])
        if "seconds" in values:  # only runs after the first one, or the advancing front, took too long
            return "ok", "", values
        return "time limit", "more than %g s" % limits.seconds, {}
    finally:  # after an interruption as well
        if process.poll() is None:
            process.kill()
            process.communicate()
    if process.returncode != 0:
        status, message = _failure(process, error, limits)
        return status, message, {}
    return "ok", "", _values(output)


def list_methods(program):
    output = subprocess.run([program, "methods"], check=True, capture_output=True, text=True).stdout
    methods = []
    for line in output.splitlines():
        key, title, is_ours, uses_threads, description = line.split("\t")
        methods.append({"key": key, "title": title, "is_ours": is_ours == "1",
                        "uses_threads": uses_threads == "1", "description": description})
    return methods


class Store:
    """One file a row. A row that is there is not made again, so that a run can be resumed."""

    def __init__(self, folder, retry):
        self.folder = folder
        self.retry = retry  # whether a row of a failure counts as none
        os.makedirs(folder, exist_ok=True)

    def _file(self, key):
        return os.path.join(self.folder, "__".join(str(word) for word in key) + ".json")

    def load(self, key):
        try:
            with open(self._file(key)) as file:
                row = json.load(file)
            return None if self.retry and row["status"] != "ok" else row
        except (FileNotFoundError, ValueError):
            return None

    def save(self, key, row):
        partial = self._file(key) + ".part"
        with open(partial, "w") as file:
            json.dump(row, file, indent=1)
        os.replace(partial, self._file(key))


class Runner:
    def __init__(self, program, output, limits, runs, pixels, retry, only_report):
        self.program = program
        self.output = output
        self.limits = limits
        self.runs = runs
        self.pixels = pixels
        self.only_report = only_report  # jobs without a row are left out
        self.store = Store(os.path.join(output, "rows"), retry)
        for folder in ("meshes", "pictures"):
            os.makedirs(os.path.join(output, folder), exist_ok=True)

    def path(self, folder, key, extension):
        return os.path.join(self.output, folder, "__".join(str(word) for word in key) + extension)

    def row(self, model, method, threads, measured=True):
        """Runs a method on a model, and measures the mesh, unless that has been done."""
        key = (model["name"], method["key"], "t%d" % threads)
        row = self.store.load(key)
        if row is not None or self.only_report:
            return row, False
        mesh = self.path("meshes", key, ".ply")
        begin = time.time()
        command = [self.program, "run", model["source"], method["key"], str(threads), str(self.runs),
                   str(self.limits.seconds / 3), mesh]
        status, message, values = run_process(command, self.limits)
        row = {"model": model["name"], "group": model["group"], "method": method["key"],
               "threads": threads, "status": status, "message": message}
        row.update(values)
        if status == "ok" and measured:
            self._measure(model, key, mesh, row)
        elif os.path.exists(mesh):
            os.remove(mesh)
        row["job_seconds"] = round(time.time() - begin, 2)
        self.store.save(key, row)
        return row, True

    def reference(self, model):
        """The measures of the mesh that came with the model, or a picture of its points."""
        key = (model["name"], "reference", "t0")
        row = self.store.load(key)
        if row is None and not self.only_report:
            row = {"model": model["name"], "group": model["group"], "method": "reference",
                   "threads": 0, "status": "ok", "message": ""}
            self._measure(model, key, "-", row)
            self.store.save(key, row)
        return row

    def _measure(self, model, key, mesh, row):
        picture = self.path("pictures", key, ".ppm")
        command = [self.program, "measure", model["source"], mesh, picture, str(self.pixels)]
        status, message, values = run_process(command, Limits(4 * self.limits.seconds, self.limits.megabytes))
        if status == "ok":
            row.update(values)
            row["picture"] = os.path.relpath(picture, self.output)
        else:
            row["status"] = "not measured"
            row["message"] = status + " " + message
