"""What a study compares: quantities of history.csv, their references, and the error of a run.

A quantity is a [[target]] of the case by its name, or REDUCE:COLUMN with REDUCE one of max, min,
final, mean, time_of_max, or curve: the whole time history, its largest difference over the largest
value of the reference.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from launch import results
from launch.case import Case
from launch.errors import InputError, did_you_mean

REDUCTIONS = ("max", "min", "final", "mean", "time_of_max", "curve")
History = dict[str, np.ndarray]


@dataclass(frozen=True)
class Quantity:
    """One quantity; `analytic` is the target's reference, None where there is no target."""

    name: str
    column: str
    reduce: str
    analytic: float | None = None

    @property
    def unit(self) -> str:
        if self.reduce == "curve":
            return "-"
        return "s" if self.reduce == "time_of_max" else results.unit_of(self.column)

    def value(self, history: History) -> float | None:
        """Its number in one run; of a curve the largest absolute value. None where there is none."""
        if self.reduce == "curve":
            values = np.abs(history.get(self.column, np.empty(0)))
            return float(np.nanmax(values)) if np.isfinite(values).any() else None
        return results.reduced(history, self.column, self.reduce)


@dataclass
class Reference:
    """What runs are compared with: numbers by quantity name, or a whole history, and where from."""

    source: str
    values: dict[str, float] = field(default_factory=dict)
    history: History = field(default_factory=dict)

    def value(self, quantity: Quantity) -> float | None:
        """The reference of a quantity, None where there is none."""
        if quantity.name in self.values:
            return self.values[quantity.name]
        return quantity.value(self.history)

    def error(self, quantity: Quantity, history: History) -> float | None:
        """|value - reference| / |reference|; the plain difference where the reference is 0."""
        value, reference = quantity.value(history), self.value(quantity)
        if value is None or reference is None:
            return None
        if quantity.reduce == "curve":
            difference = _largest_difference(quantity.column, history, self.history)
        else:
            difference = abs(value - reference)
        if difference is None:
            return None
        return difference / abs(reference) if reference else difference


def _largest_difference(column: str, history: History, reference: History) -> float | None:
    """Largest difference at the run's times that the reference covers, linear between its times."""
    if column not in reference or column not in history:
        return None
    times, values = history["time_s"], history[column]
    span = reference["time_s"]
    inside = (times >= span[0]) & (times <= span[-1] * (1 + 1e-9)) & np.isfinite(values)
    if not inside.any():
        return None
    expected = np.interp(times[inside], span, reference[column])
    return float(np.max(np.abs(values[inside] - expected)))


def choose(case: Case, names: list[str]) -> list[Quantity]:
    """The quantities named, or every target of the case. InputError where a name fits nothing."""
    targets = {t["name"]: Quantity(t["name"], t["column"], t.get("reduce", "max"), t["reference"])
               for t in case.data.get("target", [])}
    if not names and not targets:
        raise InputError(case.file, "target", None, "the case has none; name what to compare: "
                                                    "--quantity final:COLUMN of history.csv")
    chosen = []
    for name in dict.fromkeys(names or targets):
        how, separator, column = name.partition(":")
        if name in targets:
            chosen.append(targets[name])
        elif separator and how.strip() in REDUCTIONS and column.strip():
            chosen.append(Quantity(name, column.strip(), how.strip()))
        else:
            guess = did_you_mean(name, targets) or f"targets: {', '.join(targets) or 'none'}"
            raise InputError("--quantity", name, None, "is no target of the case and not REDUCE:COLUMN "
                             f"with REDUCE of {', '.join(REDUCTIONS)}; {guess}")
    return chosen


def analytic(quantities: list[Quantity]) -> Reference:
    """The references of the case's targets. InputError for a quantity that is no target."""
    for quantity in quantities:
        if quantity.analytic is None:
            raise InputError("--reference", "analytic", quantity.name,
                             "is no [[target]] of the case; use --reference best or a FILE")
    return Reference("the targets' references", {q.name: q.analytic for q in quantities})


def from_file(path: Path, quantities: list[Quantity]) -> Reference:
    """A CSV file: a time history with a column time_s, or rows of quantity,value."""
    try:
        with path.open(newline="", encoding="utf-8") as stream:
            rows = [[cell.strip() for cell in row] for row in csv.reader(stream) if row]
    except (OSError, UnicodeDecodeError) as error:
        raise InputError("--reference", str(path), None, "is not best or analytic and cannot be read "
                         f"as a file: {error}") from error
    try:
        if rows and "time_s" in rows[0]:
            table = np.array(rows[1:], dtype=float).reshape(-1, len(rows[0]))
            reference = Reference(path.name, history=dict(zip(rows[0], table.T)))
        elif rows and rows[0] == ["quantity", "value"]:
            reference = Reference(path.name, {name: float(value) for name, value in rows[1:]})
        else:
            raise ValueError("neither a column time_s nor the header quantity,value")
    except ValueError as error:
        raise InputError("--reference", str(path), None, f"cannot be used: {error}") from error
    for quantity in quantities:
        if reference.value(quantity) is None or (quantity.reduce == "curve" and not reference.history):
            raise InputError(path, quantity.name, None, "the reference has no value for this quantity")
    return reference
