"""Faults of the fault matrix that come from outside into both real engines (OpenFOAM and LIGGGHTS):
what a user writes wrong, signals, a full disk, a run that ends in numbers that are none.

Each case is a copy of one prepared run of settling_sphere, 2 + 2 ranks. What strikes during the run
does so after its first checkpoint; mended, the run then has to come to the end of one left alone."""

import os
import re
import shutil
import signal
import subprocess
import time
from pathlib import Path

from outcome import Outcome, fresh

ROOT = Path(__file__).resolve().parents[2]
CASE = ("settling_sphere", "--set", "case.end_time=0.04", "--set", "output.interval=0.005", "--set",
        "checkpoint.windows=10", "--set", "checkpoint.keep=99", "--set", "coupling.patience=3", "--ranks-fluid", "2",
        "--ranks-dem", "2")
SCRIPT, SOLUTION, VELOCITY = "dem/in.setup", "fluid/system/fvSolution", "fluid/processor1/0/U"
PAGE_BYTES = 4096


def adding(line):
    return lambda text: f"{text}\n{line}\n"


# What is written wrong: fault, side, place, file, change, words of which one must be told, and whether
# the run gets to a checkpoint before.
WRITTEN = (
    ("script error", "dem", "set-up", SCRIPT, adding("nonsense here"), ["Unknown command"], False),
    ("script error", "dem", "run", SCRIPT, adding("fix gap all print 77 '${nothing}'"),
     ["Substitution for illegal variable"], False),
    ("dictionary error", "fluid", "set-up", SOLUTION, lambda t: t.replace("PIMPLE", "PIMPEL"), ["pRefCell"], False),
    ("dictionary error", "fluid", "run", SOLUTION, lambda t: re.sub(r'"?p(Final|\.\*)?"?\n', "q\n", t), ["OpenFOAM: "],
     False),
    ("NaN in a force (script)", "dem", "run", SCRIPT,
     adding("variable push equal 0*exp(10*(step-30))\nfix push all addforce 0 0 v_push"), ["not a number"],
     True),
    ("a particle leaves (script)", "dem", "run", SCRIPT,
     adding("variable push equal 1e3*(step>60)\nfix push all addforce v_push 0 0"), ["outside the fluid mesh", "Lost atoms"],
     True),
    ("numbers overflow (boundary condition)", "fluid", "run", VELOCITY,
     lambda t: t.replace("noSlip;", "uniformFixedValue; uniformValue table ((0 (0 0 0)) (0.01 (0 0 0)) "
                                    "(0.0101 (1e200 0 0)) (1 (1e200 0 0)));"),
     ["floating-point exception"], True),
)
# Signals to one rank of a program during the run.
SIGNALS = (("kill -9", signal.SIGKILL, ["signal 9 (Killed)"]),
           ("segmentation fault (kill -SEGV)", signal.SIGSEGV, ["segmentation fault"]),
           ("a side stalls (kill -STOP)", signal.SIGSTOP, ["longer than coupling.patience"]))
PROGRAMS = {"fluid": "slidewave_foam", "dem": "slidewave_dem"}


def ranks_in(directory, name):
    """Process ids of a program that runs in a directory."""
    found = []
    for entry in Path("/proc").glob("[0-9]*"):
        try:
            words = (entry / "cmdline").read_bytes().decode().split("\0")
        except OSError:
            continue
        if Path(words[0]).name == name and str(directory) in words:
            found.append(int(entry.name))
    return sorted(found)


def size_of(folder):
    """What its files take of a file system in whole pages [bytes]."""
    return sum(-(-p.stat().st_size // PAGE_BYTES) * PAGE_BYTES for p in folder.rglob("*") if p.is_file())


class EngineFaults:
    def __init__(self, matrix):
        self.matrix, self.work = matrix, matrix.options.work
        self.programs = [matrix.options.programs / name for name in PROGRAMS.values()]

    def run_all(self):
        self.prepare()
        for fault in WRITTEN:
            self.written(*fault)
        for side in PROGRAMS:
            for what, number, words in SIGNALS:
                self.struck(what, side, number, words)
        first = sorted((self.whole / "checkpoints").iterdir())[0]
        self.disk_full("both", "checkpoints", size_of(first) * 3 // 2)
        picture = sum(map(size_of, self.whole.glob("fluid/processor*/0.005")))
        self.disk_full("fluid", "fluid", picture * 5 // 2)
        self.disk_full("dem", "dem", PAGE_BYTES * 3)  # two pictures and their list

    def prepare(self):
        self.prepared = fresh(self.work, "prepared")
        self.prepared.rmdir()
        environment = dict(os.environ, SLIDEWAVE_BUILD=str(self.matrix.options.programs.parent),
                           PYTHONDONTWRITEBYTECODE="1")
        subprocess.run(["/usr/bin/python3", "-m", "launch", "run", *CASE, "--dry-run", "--out", str(self.prepared)], cwd=ROOT,
                       env=environment, check=True, stdout=subprocess.DEVNULL)
        self.whole = self.copy("whole_engines")
        outcome = self.run(self.whole)
        assert outcome.status == 0, outcome.text

    def copy(self, name):
        directory = fresh(self.work, re.sub(r"\W+", "_", name))
        shutil.copytree(self.prepared, directory, dirs_exist_ok=True)
        return directory

    def run(self, directory, strike=None):
        return Outcome(self.matrix.line(directory, *self.programs), strike)

    def goes_on(self, directory):
        """Mended, it goes on from a checkpoint to the end of the run that was left alone."""
        again = self.run(directory)
        return (again.status == 0 and "going on after window" in again.text
                and (directory / "history.csv").read_bytes() == (self.whole / "history.csv").read_bytes())

    def written(self, what, side, place, file, change, words, after_checkpoint):
        directory = self.copy(f"{what} {place}")
        text = (directory / file).read_text()
        assert change(text) != text, f"{file} no longer holds what is changed here"
        (directory / file).write_text(change(text))
        outcome = self.run(directory)
        (directory / file).write_text(text)
        intact = self.goes_on(directory) if after_checkpoint else None
        self.matrix.judge(what, side, place, outcome, words, intact)

    def struck(self, what, side, number, words):
        directory = self.copy(f"{what} {side}")

        def strike(job):
            self.await_window(job, directory, 12)
            os.kill(ranks_in(directory, PROGRAMS[side])[-1], number)

        outcome = self.run(directory, strike)
        self.matrix.judge(what, side, "run", outcome, words, self.goes_on(directory))

    def disk_full(self, side, folder, room_bytes):
        """A folder of the run lies on a file system with so much room left."""
        what = f"disk full ({folder}/)"
        directory = self.copy(f"{what} {side}")
        place, content = directory / folder, self.work / "content"
        place.mkdir(exist_ok=True)
        shutil.rmtree(content, ignore_errors=True)
        shutil.copytree(place, content)
        size = size_of(content) + room_bytes
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(place)],
                                 capture_output=True, text=True, check=False)
        if mounted.returncode:
            print(f"left out: {what}: no mount here ({mounted.stderr.strip()})")
            return
        try:
            shutil.copytree(content, place, dirs_exist_ok=True)
            outcome = self.run(directory)
            shutil.rmtree(content)
            shutil.copytree(place, content)
        finally:
            subprocess.run(["umount", str(place)], check=True)
        shutil.copytree(content, place, dirs_exist_ok=True)
        self.matrix.judge(what, side, "run", outcome, ["No space left"], self.goes_on(directory))

    @staticmethod
    def await_window(job, directory, rows):
        """Until history.csv has so many rows."""
        history = directory / "history.csv"
        while job.poll() is None and not (history.is_file() and history.read_text().count("\n") > rows):
            time.sleep(0.005)
