"""Twelve faults on either side, before, in and after an exchange: both programs end within 10 s (a
stall: after the patience, 3 s here), the status is not 0, the reason is named, and the checkpoint
before it carries the run to the end that it would have come to.

    fault_matrix.py --bin DIR --work DIR --mpirun "mpirun ..." [--quick] [--table FILE] [--programs DIR]

--quick: every fault once. --table: writes the page docs/robustness.md. --programs: slidewave_foam
and slidewave_dem, for the faults in a script and in a dictionary; left out without.
"""

import argparse
import sys
from pathlib import Path

from engine_faults import EngineFaults
from outcome import Outcome, fresh
from pair import CASE, DEFAULTS

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
        directory = fresh(self.options.work, name)
        (directory / "case.toml").write_text(case)
        return directory

    def goes_on(self, directory, case, whole, programs):
        """The fault is mended: from the checkpoint the run comes to the right end."""
        (directory / "case.toml").write_text(case.format(**{**DEFAULTS, "patience": 3.0}))
        again = Outcome(self.line(directory, *programs))
        return (again.status == 0 and "going on after window 10" in again.text
                and (directory / "history.csv").read_bytes() == (whole / "history.csv").read_bytes())

    def judge(self, what, side, place, outcome, words, intact):
        """`intact`: whether the mended run went on to the right end; None: there was no checkpoint yet."""
        reason = outcome.reason(words)
        good = (outcome.status != 0 and outcome.seconds < 10 + self.start_s and reason is not None
                and intact is not False)
        kept = {True: "intact", False: "LOST", None: "none yet"}[intact]
        self.rows.append((what, side, place, outcome.seconds, outcome.status, reason or "none", kept, good))
        print(f"{'ok  ' if good else 'FAIL'} {what}, {side}, {place}: {outcome.seconds:.1f} s, status "
              f"{outcome.status}, {reason}, checkpoint {kept}", flush=True)
        if not good:
            self.failed.append((what, side, place))
            print(outcome.text[-3000:])

    def page(self):
        lines = ["# What happens when something breaks", "",
                 "Made by `tests/pair/fault_matrix.py --table`: twelve faults in either side, before, in and after an "
                 "exchange. With a place in the third",
                 "column: window 15 of the two fake engines, 2 + 2 ranks. With *run*: OpenFOAM and LIGGGHTS "
                 "(`settling_sphere`, 2 + 2 ranks), from outside: what a",
                 "user writes wrong, signals to one rank, a file system (tmpfs) without room. Required: both programs "
                 "end within 10 s (a stall: its patience, 3 s",
                 "here), with a status other than 0 and a reason; and from the last checkpoint the mended run comes "
                 "to exactly the end of a run without a",
                 "fault, every digit of `history.csv`. Times include the start of `mpirun` on two busy cores (signals: "
                 "from the signal on).", "",
                 "| fault | side | exchange | s | status | told | checkpoint |", "|---|---|---|---|---|---|---|"]
        for what, side, place, seconds, status, reason, kept, good in self.rows:
            told = reason.replace("|", "/")
            told = told if len(told) < 110 else told[:107] + "..."
            lines.append(f"| {what} | {side} | {place} | {seconds:.1f} | {status} | {told} | "
                         f"{kept}{'' if good else ' **missed**'} |")
        good = sum(row[-1] for row in self.rows)
        lines += ["", f"{good} of {len(self.rows)} as required." + (
            " Each fault once here (`--quick`); all places, and the real engines, are tried by `./slidewave test "
            "--full`." if self.options.quick else ""), "",
                  "A process that is "
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
        EngineFaults(matrix).run_all()
    matrix.fakes()
    if matrix.options.table:
        matrix.options.table.write_text(matrix.page())
    return 1 if matrix.failed else 0


if __name__ == "__main__":
    sys.exit(main())
