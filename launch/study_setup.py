"""From the options of `study` to points and jobs: everything that can be refused before a run."""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path

from launch import case as cases
from launch import consistency, study_ablate, study_points, study_runner
from launch import study_quantities as quantities_of
from launch.case import Case
from launch.errors import InputError
from launch.study_points import Point
from launch.study_quantities import Quantity, Reference


@dataclass
class Plan:
    """A study before it runs: `jobs` by point (one a repeat), `refused` points with the reason."""

    case: Case
    out: Path
    points: list[Point]
    quantities: list[Quantity]
    reference: Reference | None  # None: the finest run
    group: str
    jobs: dict[Point, list[study_runner.Job]]
    refused: dict[Point, str]
    grid: bool  # the last point is the finest as listed
    time: str = "wall"  # or processor


def plan(options: argparse.Namespace) -> Plan:
    """Reads the case and the grid. InputError for a bad case, key or value, before anything runs."""
    case = cases.load(options.case, options.variant, options.settings)
    points = _points(options, case)
    quantities = quantities_of.choose(case, options.quantity)
    reference = _reference(options, quantities)
    varied = study_points.keys_of(points)
    if options.group and options.group not in varied:
        raise InputError("--group", options.group, None,
                         f"is not varied; varied: {', '.join(varied) or 'nothing'}")
    out = options.out or Path("runs") / "-".join(filter(None, ("study", case.name, case.variant)))
    out = out.absolute()
    if out.exists() and not out.is_dir():
        raise InputError(out, "--out", None, "is a file; give a directory")
    if out.is_dir() and any(out.iterdir()) and not (out / "study.csv").is_file():
        raise InputError(out, "--out", None, "holds files but no study; give another directory")
    jobs, refused = {}, {}
    for point in points:
        resolved = _resolve(options, point)
        try:
            consistency.check(resolved)
        except InputError as error:
            refused[point] = str(error)
            continue
        jobs[point] = _jobs(options, resolved, point, out / "points")
    if refused and not jobs:
        raise InputError(case.file, "--vary", None, "no point can run; the first: "
                                                    + next(iter(refused.values())))
    return Plan(case, out, points, quantities, reference, options.group or "", jobs, refused,
                not options.list, options.time)


def _points(options: argparse.Namespace, case: Case) -> list[Point]:
    if options.ablate:
        if options.vary or options.list or options.group:
            raise InputError("--ablate", "--vary", None, "the two do not go together; set a key for "
                                                         "all points by --set")
        return study_ablate.points(case)
    if not options.vary and not options.list:
        raise InputError("study", "--vary", None, "missing: what to vary, e.g. --vary "
                         "coupling.window=1e-3,5e-4 (or --list FILE, --ablate)")
    varied = [study_points.parse_vary(text) for text in options.vary]
    listed = study_points.read_list(options.list) if options.list else []
    points = study_points.expand(varied, listed)
    if len(set(points)) < len(points):
        raise InputError(options.list, "--list", None, "gives a point twice; use --repeat N")
    return points


def _reference(options: argparse.Namespace, quantities: list[Quantity]) -> Reference | None:
    wanted = options.reference
    if options.ablate:
        if wanted:
            raise InputError("--reference", wanted, None, "not with --ablate, which compares with the "
                                                          "case as it is")
        return None
    if wanted is None:
        wanted = "analytic" if all(q.analytic is not None for q in quantities) else "best"
    if wanted == "best":
        return None
    if wanted == "analytic":
        return quantities_of.analytic(quantities)
    return quantities_of.from_file(Path(wanted), quantities)


def _resolve(options: argparse.Namespace, point: Point) -> Case:
    try:
        return cases.load(options.case, options.variant, [*options.settings, *point.words])
    except InputError as error:
        if error.file != "--set":
            raise
        raise InputError("--list" if options.list else "--vary", error.key, error.value,
                         str(error).rsplit(": ", 1)[-1]) from error


def _jobs(options: argparse.Namespace, case: Case, point: Point, place: Path) -> list[study_runner.Job]:
    """A job a repeat. A run of the same scene that is there already keeps its directory."""
    ranks = [options.ranks_fluid, options.ranks_dem]
    mark = study_runner.fingerprint(case, ranks)
    windows = case.get("case.end_time") / case.get("coupling.window")
    jobs = []
    for repeat in range(1, options.repeat + 1):
        tail = f"-{mark}" + (f"-r{repeat}" if repeat > 1 else "")
        there = sorted(p for p in place.glob(f"*{tail}") if p.is_dir())
        directory = there[0] if there else place / study_points.file_name(point, mark, repeat)
        jobs.append(study_runner.Job(point, directory, windows))
    return jobs
