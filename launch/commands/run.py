"""Prepares a case, prints the plain mpirun line, runs it with progress, writes the report.

The run directory holds everything: history.csv, summary.json, report.html, fluid/ (open
fluid/case.foam in ParaView) and dem/ (open dem/particles.vtk.series).
"""

from __future__ import annotations

import argparse
from pathlib import Path

from launch import case as cases
from launch import preflight, prepare, process, progress, ranks, restart, run_directory
from launch.commands import report
from launch.errors import InputError, RunError

NAME = "run"
HELP = "prepare a case, run it coupled, write the report"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Adds the options of `run`."""
    case_arguments(parser)
    parser.add_argument("--dry-run", action="store_true",
                        help="prepare the directory completely, print the mpirun line, stop")


def case_arguments(parser: argparse.ArgumentParser) -> None:
    """Adds the options that say what is prepared, and where."""
    parser.add_argument("case", metavar="CASE", help="directory with a case.toml, or a name below cases/")
    parser.add_argument("--variant", metavar="V", help="variant of the case (default: the case's own)")
    parser.add_argument("--set", metavar="KEY=VALUE", action="append", default=[], dest="settings",
                        help="change any key, e.g. --set coupling.window=0.01 (repeatable)")
    parser.add_argument("--ranks-fluid", metavar="N", type=positive, help="ranks of the fluid side")
    parser.add_argument("--ranks-dem", metavar="N", type=positive, help="ranks of the particle side")
    parser.add_argument("--out", metavar="DIR", type=Path,
                        help="run directory (default runs/CASE-VARIANT; an older run is kept as .1, .2)")
    parser.add_argument("--overwrite", action="store_true", help="replace the run that DIR holds")
    parser.add_argument("--force", action="store_true", help="run although the pre-flight check says no")
    parser.add_argument("--restart", action="store_true",
                        help="go on from the newest complete checkpoint of the run in DIR (docs/restart.md)")


def positive(text: str) -> int:
    """A whole number of at least 1."""
    value = int(text)
    if value < 1:
        raise argparse.ArgumentTypeError("must be at least 1")
    return value


def make_ready(options: argparse.Namespace) -> prepare.Prepared:
    """A complete run directory from the options of case_arguments(); prints the plain mpirun line.
    RunError where the pre-flight check refuses the scene."""
    case = cases.load(options.case, options.variant, options.settings)
    if options.restart:
        return _take_up(case, options)
    prepare.check_input(case)
    place = run_directory.make(options.out, case.name, case.variant, options.overwrite)
    directory = place.directory
    if place.kept:
        progress.say(f"the run that was here is kept in {place.kept}")
    progress.say(f"preparing {case.name}{' ' + case.variant if case.variant else ''} in {directory}")
    try:
        ready = prepare.prepare(case, directory, options.ranks_fluid, options.ranks_dem)
    except InputError:
        place.withdraw()
        raise
    findings = preflight.examine(case, ready)
    worth_saying = [f for f in findings if f.verdict in ("bad", "warn")]
    for line in preflight.lines(worth_saying) if worth_saying else []:
        progress.say(line)
    if any(f.bad for f in findings) and not options.force:
        place.withdraw()
        raise RunError("the pre-flight check refuses this scene (--force runs it all the same); "
                       "./slidewave check shows every number")
    progress.say(f"prepared in {ready.prepare_s:.1f} s")
    progress.say(ranks.mpirun_line(directory, ready.ranks_fluid, ready.ranks_dem,
                                   ready.fluid_engine, ready.dem_engine))
    return ready


def _take_up(case: cases.Case, options: argparse.Namespace) -> prepare.Prepared:
    if options.overwrite:
        raise InputError("command line", "--overwrite", None, "contradicts --restart")
    directory = run_directory.place_of(options.out, case.name, case.variant)
    ready = restart.take_up(case, directory, options.ranks_fluid, options.ranks_dem)
    progress.say(ranks.mpirun_line(directory, ready.ranks_fluid, ready.ranks_dem, ready.fluid_engine))
    return ready


def main(options: argparse.Namespace) -> int:
    """Runs the command; the exit status is that of the run, 1 where a required target is missed."""
    clock = process.Clock()
    ready = make_ready(options)
    directory = ready.directory
    if options.dry_run:
        return 0
    status = process.run(ready)
    extra = {"prepare_s": ready.prepare_s, "total_s": clock.elapsed_s()}
    if ready.facts.mesh is not None:
        extra["cells"] = ready.facts.mesh.cells
    report.finish(directory, extra, status)
    report.build(directory)
    return report.conclude(directory, status, clock)
