"""Results of a run: history.csv, summary.json, and the targets of the case set against them."""

from __future__ import annotations

import csv
import json
import math
from pathlib import Path

import numpy as np

UNITS = {"kg_m_s": "kg m/s", "m_s2": "m/s2", "kg_s": "kg/s", "kg_m3": "kg/m3", "m_s": "m/s", "m3": "m3",
         "m2": "m2", "Pa_m": "Pa/m", "Pa": "Pa", "kg": "kg", "J": "J", "N": "N", "m": "m", "s": "s"}
BOOKKEEPING = ("window", "time_s")


def unit_of(column: str) -> str:
    """Unit that a column's name ends in, "" where it has none."""
    return next((unit for tail, unit in UNITS.items() if column.endswith("_" + tail)), "")


def plain_name(column: str) -> str:
    """A column's name without its unit, for people."""
    tail = next((t for t in UNITS if column.endswith("_" + t)), None)
    return (column[: -len(tail) - 1] if tail else column).replace("_", " ")


def read_history(directory: Path) -> dict[str, np.ndarray]:
    """Columns of history.csv, (windows,) each; empty where there is none. A torn last row is dropped."""
    path = directory / "history.csv"
    if not path.is_file():
        return {}
    with path.open(newline="") as stream:
        rows = list(csv.reader(stream))
    if not rows:
        return {}
    values = [[_number(v) for v in row] for row in rows[1:] if len(row) == len(rows[0])]
    table = np.array(values, dtype=float).reshape(-1, len(rows[0]))
    return {name.strip(): table[:, k] for k, name in enumerate(rows[0])}


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return math.nan


def reduced(history: dict[str, np.ndarray], column: str, how: str) -> float | None:
    """One number of a column: max, min, final, mean or time_of_max; None where it has no value."""
    values = history.get(column, np.empty(0))
    good = np.isfinite(values)
    if not good.any():
        return None
    if how == "time_of_max":
        return float(history["time_s"][int(np.nanargmax(np.where(good, values, np.nan)))])
    operation = {"max": np.max, "min": np.min, "mean": np.mean, "final": lambda v: v[-1]}[how]
    return float(operation(values[good]))


def up_to(history: dict[str, np.ndarray], until_s: float | None) -> dict[str, np.ndarray]:
    """The rows of a history up to a time, all of them for None."""
    if until_s is None or "time_s" not in history:
        return history
    kept = history["time_s"] <= until_s
    return {column: values[kept] for column, values in history.items()}


def applies(target: dict, case: dict) -> bool:
    """Whether the side runs whose observer fills the target's column."""
    sides = {"wave": "fluid", "gauge": "fluid", "slide": "dem", "particle": "dem"}
    seen_by = [sides[o["type"]] for name, o in case.get("observe", {}).items() if target["column"].startswith(name + "_")]
    return not seen_by or case.get(seen_by[0], {}).get("engine") != "none"


def judge(target: dict, history: dict[str, np.ndarray]) -> dict:
    """One row of summary.json's `targets`: both tolerances, where given, must hold."""
    how = target.get("reduce", "max")
    history = up_to(history, target.get("until"))
    value, reference = reduced(history, target["column"], how), target["reference"]
    row = {"name": target["name"], "value": value, "reference": reference, "relative_error": None,
           "tolerance": target.get("tolerance"), "tolerance_absolute": target.get("tolerance_absolute"),
           "required": target.get("required", False), "pass": False, "column": target["column"],
           "reduce": how, "unit": "s" if how == "time_of_max" else unit_of(target["column"]),
           "source": target["source"]}
    for extra in ("until", "one_way", "no_water"):
        if extra in target:
            row[extra] = target[extra]
    if value is None:
        return row
    error = value - reference
    row["relative_error"] = abs(error / reference) if reference else None
    limits = []
    if row["tolerance"] is not None:
        limits.append(row["tolerance"] * abs(reference))
    if row["tolerance_absolute"] is not None:
        limits.append(row["tolerance_absolute"])
    row["pass"] = all(abs(error) <= limit for limit in limits)
    return row


def quantities(history: dict[str, np.ndarray]) -> list[dict]:
    """Last value of every column that is not bookkeeping, under its name, and largest, as max_NAME."""
    rows = []
    for column in (c for c in history if c not in BOOKKEEPING):
        for name, how in ((column, "final"), (f"max_{column}", "max")):
            value = reduced(history, column, how)
            if value is not None and name.count("max_") < 2:
                rows.append({"name": name, "value": value, "unit": unit_of(column) or "-"})
    return rows


def read_summary(directory: Path) -> dict:
    """summary.json, {} where there is none or it is torn."""
    try:
        return json.loads((directory / "summary.json").read_text())
    except (OSError, json.JSONDecodeError):
        return {}


def finite(value: object) -> object:
    """`value` with null for what JSON cannot hold (nan, inf)."""
    if isinstance(value, float) and not math.isfinite(value):
        return None
    if isinstance(value, dict):
        return {k: finite(v) for k, v in value.items()}
    if isinstance(value, list):
        return [finite(v) for v in value]
    return value


def write_summary(directory: Path, summary: dict) -> None:
    """Replaces summary.json in one step."""
    new = directory / "summary.json.new"
    new.write_text(json.dumps(finite(summary), indent=1) + "\n")
    new.replace(directory / "summary.json")
