"""Error against run time: runs a grid of settings and says which is worth its time.

Every point is one `slidewave run`. A point that is complete in DIR is not run again, so the same
command goes on after an interruption, and a larger grid runs only what is new. A point that fails
is a row with its reason; the study goes on.

quantities   a [[target]] of the case by its name (default: all), or REDUCE:COLUMN of history.csv
             with REDUCE of max, min, final, mean, time_of_max, curve (largest difference of the
             whole time history over its largest value), e.g. curve:sphere_vz_m_s
reference    analytic: the targets' references (default where all quantities are targets)
             best: the run of the last-listed value of each key, where that fails or with --list
             the costliest (default otherwise)
             FILE.csv: a time history with a column time_s, or rows under the header quantity,value

DIR/study.csv a row a point: settings, status, value, reference and error of each quantity, error
              (the largest), times [s], budgets, reason of a failure
DIR/study.svg error against run time, the Pareto front labelled with its settings
DIR/points/   the run directories and the output of each

exit status: 0 done; 1 a point failed; 2 bad input

examples:
  slidewave study settling_sphere --variant re_100 --vary coupling.window=5e-3,2e-3,1e-3
  slidewave study vajont_east --ablate --out runs/terms
"""

from __future__ import annotations

import argparse
import signal
from pathlib import Path

from launch import study_runner, study_schedule, study_setup, study_table, study_verdict
from launch.commands.run import positive
from launch.errors import RunError
from launch.progress import say

NAME = "study"
HELP = "error against run time over a grid of settings"


def fraction(text: str) -> float:
    """An error above 0."""
    value = float(text)
    if not 0 < value < 1e6:
        raise argparse.ArgumentTypeError("must be above 0; 0.02 is 2 %")
    return value


def arguments(parser: argparse.ArgumentParser) -> None:
    """Adds the options of `study`."""
    add = parser.add_argument
    add("case", metavar="CASE", help="directory with a case.toml, or a name below cases/")
    add("--vary", metavar="KEY=V1,V2,...", action="append", default=[],
        help="a key of case.toml and its values, finest last; repeated: all combinations")
    add("--list", metavar="FILE", type=Path, help="CSV, keys in the first line, a point a row")
    add("--ablate", action="store_true", help="turn each optional term off in turn, show what changes")
    add("--variant", metavar="V", help="variant of the case (default: the case's own)")
    add("--set", metavar="KEY=VALUE", action="append", default=[], dest="settings",
        help="change a key for all points (repeatable)")
    add("--quantity", metavar="NAME", action="append", default=[], help="what to compare (repeatable)")
    add("--reference", metavar="best|analytic|FILE", help="what to compare with")
    add("--group", metavar="KEY", help="a varied key: each of its values has its own best run and front")
    add("--error", metavar="E", type=fraction, default=0.02, help="error to reach (default 0.02: 2 %%)")
    add("--out", metavar="DIR", type=Path, help="default runs/study-CASE-VARIANT; an older study goes on")
    add("--jobs", metavar="N", type=positive, default=1, help="points at a time (default 1: fair times)")
    add("--time", choices=("wall", "processor"), default="wall",
        help="what counts as run time: processor is what all ranks worked, without waiting (busy machines, --jobs)")
    add("--repeat", metavar="N", type=positive, default=1, help="runs of each point, for the noise of times")
    add("--ranks-fluid", metavar="N", type=positive, help="ranks of the fluid side")
    add("--ranks-dem", metavar="N", type=positive, help="ranks of the particle side")
    add("--force", action="store_true", help="run points that the pre-flight check refuses")


def main(options: argparse.Namespace, runner: study_runner.Runner | None = None) -> int:
    """Runs the command; `runner` stands in for `slidewave run` in tests."""
    plan = study_setup.plan(options)
    plan.out.mkdir(parents=True, exist_ok=True)
    runner = runner or study_runner.CommandRunner(plan.case, options.settings, _passed_on(options))
    jobs = [job for found in plan.jobs.values() for job in found]
    repeats = f" x {options.repeat} repeats" if options.repeat > 1 else ""
    say(f"{len(plan.points)} points{repeats}, {len(jobs)} runs, {sum(j.windows for j in jobs):.0f} windows "
        f"in all; time is estimated after the first run; results in {plan.out}")
    for point, reason in plan.refused.items():
        say(f"not run: {point.label}: {reason}")
    reasons = dict(plan.refused)

    def write_so_far() -> None:
        so_far = study_verdict.rows_of(plan, reasons, pending=True)
        study_table.write(plan.out / "study.csv", so_far, plan.quantities)

    def note(job: study_runner.Job, reason: str) -> None:
        if reason:
            reasons[job.point] = reason
        write_so_far()

    write_so_far()
    previous = signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        study_schedule.run_all(jobs, runner, options.jobs, note)
    except KeyboardInterrupt as stop:
        raise RunError("stopped; the same command goes on where it was") from stop
    finally:
        signal.signal(signal.SIGTERM, previous)
    rows = study_verdict.rows_of(plan, reasons)
    study_verdict.judge(plan, rows, options.ablate, options.error)
    say(f"written: {plan.out / 'study.csv'}, study.svg")
    failed = [row for row in rows if not row.completed]
    if failed:
        say(f"{len(failed)} of {len(rows)} points failed; see the reasons above")
    return 1 if failed else 0


def _passed_on(options: argparse.Namespace) -> list[str]:
    """Options of `run` that every point gets."""
    words = ["--force"] if options.force else []
    for name in ("fluid", "dem"):
        ranks = getattr(options, f"ranks_{name}")
        words += [f"--ranks-{name}", str(ranks)] if ranks else []
    return words
