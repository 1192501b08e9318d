"""One row of a study: what a point gave against the reference, and what it cost."""

from __future__ import annotations

import statistics
from dataclasses import dataclass, field
from pathlib import Path

from launch import results
from launch.study_points import Point
from launch.study_quantities import History, Quantity, Reference


@dataclass
class Row:
    """A point after its runs. Times are medians over the repeats, spreads largest minus smallest; `by`:
    which of them counts, wall time or the processor time that all ranks worked (waiting left out);
    `errors` and `values` by quantity name; `worst` is the largest error of all quantities; `floor` the
    error of the reference itself, where that is a run (0: not known, or none)."""

    point: Point
    status: str = "pending"
    reason: str = ""
    directories: list[Path] = field(default_factory=list)
    histories: list[History] = field(default_factory=list)
    summaries: list[dict] = field(default_factory=list)
    wall_s: float = 0.0
    wall_spread_s: float = 0.0
    core_s: float = 0.0
    processor_s: float = 0.0
    processor_spread_s: float = 0.0
    by: str = "wall"
    values: dict[str, float] = field(default_factory=dict)
    references: dict[str, float] = field(default_factory=dict)
    errors: dict[str, float] = field(default_factory=dict)
    worst: float | None = None
    floor: float = 0.0
    is_reference: bool = False
    on_front: bool = False

    @property
    def completed(self) -> bool:
        return self.status == "completed"

    @property
    def time_s(self) -> float:
        """The time that counts."""
        return self.processor_s if self.by == "processor" else self.wall_s

    @property
    def time_spread_s(self) -> float:
        """Its spread over the repeats."""
        return self.processor_spread_s if self.by == "processor" else self.wall_spread_s

    @property
    def counts(self) -> bool:
        """Whether it takes part in fronts and fits: complete, and neither the reference itself nor
        too close to it to be told from it."""
        if not self.completed or self.worst is None or self.is_reference:
            return False
        return self.worst >= 0.5 * self.floor


def read(point: Point, directories: list[Path], quantities: list[Quantity], reason: str) -> Row:
    """Reads the runs of a point. Failed where a run is not complete or lacks a quantity."""
    row = Row(point, directories=directories)
    row.summaries = [results.read_summary(d) for d in directories]
    if reason or any(s.get("status") != "completed" for s in row.summaries):
        row.status, row.reason = "failed", reason or "not run"
        return row
    row.histories = [results.read_history(d) for d in directories]
    for quantity in quantities:
        found = [v for v in map(quantity.value, row.histories) if v is not None]
        if len(found) < len(row.histories):
            row.status, row.reason = "failed", f"history.csv has no value of {quantity.column}"
            return row
        row.values[quantity.name] = statistics.median(found)
    walls = [float(s.get("wall_s") or s.get("total_s") or 0) for s in row.summaries]
    row.wall_s, row.wall_spread_s = statistics.median(walls), max(walls) - min(walls)
    worked = [worked_s(s) for s in row.summaries]
    row.processor_s, row.processor_spread_s = statistics.median(worked), max(worked) - min(worked)
    row.core_s = statistics.median(float(s.get("core_s") or 0) for s in row.summaries)
    row.status = "completed"
    return row


def worked_s(summary: dict) -> float:
    """Processor seconds of all ranks without what they waited for each other."""
    ranks = summary.get("ranks") or {}
    return sum(ranks.get(side, 0) * sum(s for phase, s in phases.items() if phase != "wait")
               for side, phases in (summary.get("processor_timings") or {}).items())


def best(rows: list[Row], listed_last_is_finest: bool) -> Row | None:
    """The finest run: that of the last-listed values where it is complete, else the costliest."""
    done = [row for row in rows if row.completed]
    if listed_last_is_finest and rows and rows[-1].completed:
        return rows[-1]
    return max(done, key=lambda row: (row.core_s, row.time_s), default=None)


def compare(rows: list[Row], quantities: list[Quantity], reference: Reference) -> None:
    """Fills references, errors and the largest error of every complete row."""
    for row in (r for r in rows if r.completed):
        for quantity in quantities:
            row.references[quantity.name] = reference.value(quantity)
            errors = [reference.error(quantity, history) for history in row.histories]
            known = [e for e in errors if e is not None]
            if known:
                row.errors[quantity.name] = statistics.median(known)
        row.worst = max(row.errors.values(), default=None)
