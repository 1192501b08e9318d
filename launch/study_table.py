"""study.csv, a row a point, and the lines that a study prints."""

from __future__ import annotations

import csv
from pathlib import Path

from launch.study_points import keys_of
from launch.study_quantities import Quantity
from launch.study_results import Row

COUNTS = ("windows", "particles", "cells")


def header(rows: list[Row], quantities: list[Quantity]) -> list[str]:
    """Names of the columns: keys as in case.toml, quantities with their unit, times in s."""
    names = ["point", *keys_of([row.point for row in rows]), "status"]
    for quantity in quantities:
        unit = f" [{quantity.unit}]" if quantity.unit not in ("", "-") else ""
        names += [quantity.name + unit, f"{quantity.name} reference", f"{quantity.name} error"]
    return names + ["error", "is_reference", "on_front", "wall_s", "wall_spread_s", "core_s", "processor_s",
                    "repeats", *COUNTS, *_budgets(rows), "version", "reason"]


def _budgets(rows: list[Row]) -> list[str]:
    return sorted({name for row in rows for s in row.summaries[:1] for name in s.get("budgets") or {}})


def cells(row: Row, rows: list[Row], quantities: list[Quantity]) -> list[str]:
    """The texts of one row, empty where there is no value."""
    texts = [row.point.label, *(row.point.text(k) for k in keys_of([r.point for r in rows])), row.status]
    for quantity in quantities:
        texts += [_text(row.values.get(quantity.name)), _text(row.references.get(quantity.name)),
                  _text(row.errors.get(quantity.name))]
    texts += [_text(row.worst), str(int(row.is_reference)), str(int(row.on_front))]
    summary = row.summaries[0] if row.completed else {}
    times = (row.wall_s, row.wall_spread_s, row.core_s, row.processor_s) if row.completed else (None,) * 4
    budgets = summary.get("budgets") or {}
    texts += [*("" if t is None else f"{t:.3f}" for t in times), str(len(row.directories))]
    texts += [_text(summary.get(name)) for name in COUNTS]
    texts += [_text(budgets.get(name)) for name in _budgets(rows)]
    return texts + [str(summary.get("version", "")), row.reason]


def write(path: Path, rows: list[Row], quantities: list[Quantity]) -> None:
    """Replaces study.csv in one step."""
    new = path.with_name(path.name + ".new")
    with new.open("w", newline="", encoding="utf-8") as stream:
        table = csv.writer(stream, lineterminator="\n")
        table.writerow(header(rows, quantities))
        table.writerows(cells(row, rows, quantities) for row in rows)
    new.replace(path)


def lines(rows: list[Row]) -> list[str]:
    """The table for the terminal: settings, error, time; a star for the front."""
    width = max([8, *(len(row.point.label) for row in rows)])
    found = [f"  {'settings':<{width}}      error   wall [s]   core [s]  worked [s]"]
    for row in rows:
        if not row.completed:
            found.append(f"  {row.point.label:<{width}}  {row.status}: {row.reason}")
            continue
        error = "-" if row.worst is None else f"{100 * row.worst:.3g} %"
        if not row.counts and row.worst is not None:
            error = "reference" if row.is_reference else "as ref."
        mark = "*" if row.on_front else " "
        found.append(f"{mark} {row.point.label:<{width}}  {error:>9}  {row.wall_s:9.2f}  {row.core_s:9.2f}"
                     f"  {row.processor_s:10.2f}")
    return found


def change_lines(rows: list[Row], quantities: list[Quantity]) -> list[str]:
    """For --ablate: the change of every quantity and of the run time without each term."""
    base, found = rows[0], []
    for row in rows[1:]:
        if not (row.completed and base.completed):
            found.append(f"  {row.point.label}: {row.reason or 'nothing to compare with'}")
            continue
        changes = [f"{q.name} {_change(row.values[q.name], base.values[q.name], q)}" for q in quantities
                   if q.reduce != "curve"]
        changes += [f"{q.name} differs by {100 * row.errors[q.name]:.3g} %" for q in quantities
                    if q.reduce == "curve" and q.name in row.errors]
        time = 100 * (row.time_s / base.time_s - 1) if base.time_s else 0.0
        found.append(f"  {row.point.label}: {', '.join(changes)}; run time {time:+.0f} %")
    return found


def _change(value: float, base: float, quantity: Quantity) -> str:
    if base:
        return f"{100 * (value - base) / abs(base):+.3g} %"
    return f"{value - base:+.3g} {quantity.unit}".rstrip()


def _text(value: object) -> str:
    return "" if value is None else f"{value:.10g}" if isinstance(value, (int, float)) else str(value)
