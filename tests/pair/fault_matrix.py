"""Twelve faults on either side, before, in and after an exchange: both programs end within 10 s (a
stall: after the patience, 3 s here), the status is not 0, the reason is named, and the checkpoint
before it carries the run to the end that it would have come to.

    fault_matrix.py --bin DIR --work DIR --mpirun "mpirun ..." [--quick] [--table FILE] [--programs DIR]

--quick: every fault once. --table: writes the page docs/robustness.md. --programs: slidewave_foam
and slidewave_dem, for the faults in a script and in a dictionary; left out without.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

from pair import CASE, DEFAULTS

ROOT = Path(__file__).resolve().parents[2]
PLACES = ("before", "in", "after")
SIDES = ("fluid", "dem")
# Fault: what it is, and words of which one must be told.
FAKES = {
    "exception": ("an engine throws", ["broke on purpose"]),
    "nan_force": ("NaN in a force", ["is not a finite number"]),
    "nan_field": ("NaN in a field", ["is not a finite number"]),
    "segfault": ("segmentation fault", ["segmentation fault"]),
    "kill": ("kill -9", ["signal 9 (Killed)"]),
    "exit": ("exit(0) in mid-run", ["called exit()"]),
    "disk": ("disk full", ["File too large"]),
    "lost": ("a particle leaves", ["outside the fluid mesh"]),
    "stall": ("a side stalls", ["longer than coupling.patience"]),
    "layout": ("columns change", ["changed its quantities", "changed the names of its quantities"]),
}


class Outcome:
    """How a run ended: seconds, status, what was told."""

    def __init__(self, line):
        start = time.monotonic()
        done = subprocess.run(line, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=100,
                              check=False, env=dict(os.environ, WM_PROJECT_DIR="/usr/share/openfoam"))
        self.seconds, self.status, self.text = time.monotonic() - start, done.returncode, done.stdout

    def reason(self, words):
        """The line that names the reason, without the directory."""
        for text in self.text.splitlines():
            if any(word in text for word in words):
                text = re.sub(r"^slidewave: |^mpirun noticed that ", "", text.strip())
                return re.sub(r"PID \d+ on node \S+ ", "", re.sub(r"(/[\w.-]+)+/(?=[\w.]+)", "", text))
        return None


class Matrix:
    def __init__(self, options):
        self.options = options
        self.rows, self.failed = [], []
        self.start_s = 5.0  # what mpirun takes to start and run without a fault

    def line(self, directory, fluid, dem):
        return [*self.options.mpirun.split(), "-np", "2", str(fluid), str(directory), ":", "-np", "2", str(dem),
                str(directory)]

    def fakes(self):
        """Faults in the engines' calls."""
        programs = self.options.bin / "faulty_fluid", self.options.bin / "faulty_dem"
        case = CASE + "[checkpoint]\nwindows = 10\nkeep = 9\n"
        whole = self.fresh("whole", case.format(**{**DEFAULTS, "patience": 3.0}))
        undisturbed = Outcome(self.line(whole, *programs))
        assert undisturbed.status == 0, undisturbed.text
        self.start_s = undisturbed.seconds
        for number, (kind, (what, words)) in enumerate(FAKES.items()):
            cells = [(side, place) for side in SIDES for place in PLACES]
            for side, place in [cells[number % len(cells)]] if self.options.quick else cells:
                fault = f"matrix {kind} {side} {place}"
                directory = self.fresh(fault, case.format(**{**DEFAULTS, "patience": 3.0, "fault": fault}))
                outcome = Outcome(self.line(directory, *programs))
                self.judge(what, side, place, outcome, words, self.goes_on(directory, case, whole, programs))

    def fresh(self, name, case):
        directory = self.options.work / name.replace(" ", "_")
        shutil.rmtree(directory, ignore_errors=True)
        directory.mkdir(parents=True)
        (directory / "case.toml").write_text(case)
        return directory

    def goes_on(self, directory, case, whole, programs):
        """The fault is mended: from the checkpoint the run comes to the right end."""
        (directory / "case.toml").write_text(case.format(**{**DEFAULTS, "patience": 3.0}))
        again = Outcome(self.line(directory, *programs))
        return (again.status == 0 and "going on after window 10" in again.text
                and (directory / "history.csv").read_bytes() == (whole / "history.csv").read_bytes())

    def engines(self):
        """Faults in what the user writes: at set-up, and when it is first used in the run."""
        prepared = self.options.work / "prepared"
        shutil.rmtree(prepared, ignore_errors=True)
        prepared.parent.mkdir(parents=True, exist_ok=True)
        environment = dict(os.environ, SLIDEWAVE_BUILD=str(self.options.programs.parent), PYTHONDONTWRITEBYTECODE="1")
        subprocess.run([sys.executable, "-m", "launch", "run", "settling_sphere", "--dry-run", "--out", str(prepared),
                        "--set", "case.end_time=0.02", "--set", "checkpoint.windows=10", "--ranks-fluid", "2",
                        "--ranks-dem", "2"], cwd=ROOT, env=environment, check=True, stdout=subprocess.DEVNULL)
        programs = self.options.programs / "slidewave_foam", self.options.programs / "slidewave_dem"
        script, solution = "dem/in.setup", "fluid/system/fvSolution"
        for what, side, place, file, change, words in (
                ("script error", "dem", "before", script, lambda t: t + "\nnonsense here\n", ["Unknown command"]),
                ("script error", "dem", "in", script, lambda t: t + "\nfix gap all print 77 '${nothing}'\n",
                 ["Substitution for illegal variable"]),
                ("dictionary error", "fluid", "before", solution, lambda t: t.replace("PIMPLE", "PIMPEL"),
                 ["PIMPLE"]),
                ("dictionary error", "fluid", "in", solution, lambda t: re.sub(r'"?p(Final|\.\*)?"?\n', "q\n", t),
                 ["OpenFOAM: "])):
            directory = self.options.work / f"{what}_{place}".replace(" ", "_")
            shutil.rmtree(directory, ignore_errors=True)
            shutil.copytree(prepared, directory)
            text = (directory / file).read_text()
            assert change(text) != text, f"{file} no longer holds what is changed here"
            (directory / file).write_text(change(text))
            outcome = Outcome(self.line(directory, *programs))
            left = sorted((directory / "checkpoints").glob("*/manifest.json"))
            self.judge(what, side, place, outcome, words, True if place == "before" or what.startswith("dict")
                       else bool(left))

    def judge(self, what, side, place, outcome, words, intact):
        reason = outcome.reason(words)
        good = outcome.status != 0 and outcome.seconds < 10 + self.start_s and reason is not None and intact
        self.rows.append((what, side, place, outcome.seconds, outcome.status, reason or "none", intact, good))
        print(f"{'ok  ' if good else 'FAIL'} {what}, {side}, {place}: {outcome.seconds:.1f} s, status "
              f"{outcome.status}, {reason}, checkpoint {'intact' if intact else 'LOST'}", flush=True)
        if not good:
            self.failed.append((what, side, place))
            print(outcome.text[-3000:])

    def page(self):
        lines = ["# What happens when something breaks", "",
                 "Made by `tests/pair/fault_matrix.py --table`: twelve faults in either side, before, in and after an "
                 "exchange (window 15 of the",
                 "two fake engines, 2 + 2 ranks; scripts and dictionaries of both real ones). Required: both programs "
                 "end within 10 s (a stall: its patience,",
                 "3 s here), with a status other than 0 and a reason; and from the checkpoint of window 10 the "
                 "mended run comes to exactly the end",
                 "of a run without a fault. Times include the start of `mpirun` on two busy cores.", "",
                 "| fault | side | exchange | s | status | told | checkpoint |", "|---|---|---|---|---|---|---|"]
        for what, side, place, seconds, status, reason, intact, good in self.rows:
            told = reason.replace("|", "/")
            told = told if len(told) < 110 else told[:107] + "..."
            lines.append(f"| {what} | {side} | {place} | {seconds:.1f} | {status} | {told} | "
                         f"{'intact' if intact else 'lost'}{'' if good else ' **missed**'} |")
        good = sum(row[-1] for row in self.rows)
        lines += ["", f"{good} of {len(self.rows)} as required." + (
            " Each fault once here (`--quick`); all places, scripts and dictionaries are tried by `./slidewave test "
            "--full`." if self.options.quick else ""), "",
                  "A script or a dictionary is read at set-up (before) and used in the run (in); nothing of it is "
                  "left for afterwards. A process that is",
                  "killed (`kill -9`, the kernel for lack of memory) cannot tell: mpirun names the signal, and the "
                  "report repeats it. A full disk is met",
                  "where the next byte is written: rows of `history.csv` at once, a rank without files at the next "
                  "checkpoint.", ""]
        return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=Path, required=True)
    parser.add_argument("--work", type=Path, required=True)
    parser.add_argument("--mpirun", required=True)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--table", type=Path)
    parser.add_argument("--programs", type=Path)
    matrix = Matrix(parser.parse_args())
    if matrix.options.programs:
        matrix.engines()
    matrix.fakes()
    if matrix.options.table:
        matrix.options.table.write_text(matrix.page())
    return 1 if matrix.failed else 0


if __name__ == "__main__":
    sys.exit(main())
