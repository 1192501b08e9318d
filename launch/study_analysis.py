"""What a study says: the Pareto front, the order of convergence by key, and one plain sentence."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from launch.study_points import keys_of
from launch.study_results import Row
from launch.study_schedule import duration

ORDERS = np.concatenate([np.arange(-6.0, -0.02, 0.05), np.arange(0.05, 6.01, 0.05)])
LEAST_POINTS = 3
NOTHING = 1e-14  # relative errors below this are round-off
SAME = 1.02  # errors whose largest is below this times the smallest do not depend on the key


def front(costs: list[float], errors: list[float]) -> list[int]:
    """Indices of the points that no other beats in both cost and error, cheapest first."""
    chosen: list[int] = []
    for index in sorted(range(len(costs)), key=lambda i: (costs[i], errors[i])):
        if not chosen or errors[index] < errors[chosen[-1]]:
            chosen.append(index)
    return chosen


def mark_front(rows: list[Row]) -> None:
    """Sets on_front by the time that counts and the largest error."""
    taken = [row for row in rows if row.counts]
    for index in front([r.time_s for r in taken], [r.worst for r in taken]):
        taken[index].on_front = True


@dataclass(frozen=True)
class Order:
    """error ~ |h^order - h_ref^order| along one key; residual: rms of the natural logarithm; ratio:
    largest over smallest error; left: what the fit leaves as error of the finest run itself."""

    key: str
    order: float
    residual: float
    points: int
    ratio: float
    left: float

    def __str__(self) -> str:
        if self.ratio < SAME:
            return f"{self.key}: no effect on the error ({self.points} points)"
        return f"{self.key}: order {self.order:.2f} ({self.points} points, rms {self.residual:.2g})"


def fit_order(sizes: list[float], errors: list[float], finest: float | None = None) -> tuple[float, float]:
    """Order p and rms residual of log e = log C + log |h^p - h_ref^p|, least squares. `finest` is
    h_ref, the size of the run that errors are measured against; None where they are true errors."""
    h, e = np.array(sizes), np.log(np.array(errors))

    def residual(order: float) -> float:
        shape = h**order if finest is None else np.abs(h**order - finest**order)
        return float(np.std(e - np.log(shape)))

    start = min(ORDERS, key=residual)
    near = np.linspace(start - 0.05, start + 0.05, 201)
    order = min((p for p in near if abs(p) > 1e-3), key=residual)
    return float(order), residual(order)


def orders(rows: list[Row], quantity: str) -> list[Order]:
    """The order along each numeric key, the other keys at the values of the last complete row, or
    at those that leave most points. Keys with fewer than 3 usable points give none."""
    found = []
    reference = next((row for row in rows if row.is_reference), None)
    usable = [row for row in rows if row.counts and row.errors.get(quantity, 0) > NOTHING]
    for key in keys_of([row.point for row in rows]):
        lines: dict[tuple, list[Row]] = {}
        for row in usable:
            if row.point.number(key) is not None and row.point.number(key) > 0:
                others = tuple(s for s in row.point.settings if s[0] != key)
                lines.setdefault(others, []).append(row)
        if not lines:
            continue
        finest = reference or rows[-1]
        wanted = tuple(s for s in finest.point.settings if s[0] != key)
        line = lines.get(wanted, [])
        base = reference.point.number(key) if reference else None
        if len(line) < LEAST_POINTS:  # away from the reference its distance is no error of this key
            line = [] if reference else max(lines.values(), key=len)
        sizes = [row.point.number(key) for row in line]
        if len(line) >= LEAST_POINTS and len(set(sizes)) == len(sizes):
            errors = [row.errors[quantity] for row in line]
            ratio = max(errors) / min(errors)
            order, residual = fit_order(sizes, errors, base)
            left = 0.0
            if base is not None and order > 0 and ratio >= SAME:
                left = float(np.mean(np.array(errors) / np.abs(np.array(sizes) ** order - base**order)))
                left *= base**order
            found.append(Order(key, order, residual, len(line), ratio, left))
    return found


def set_floor(rows: list[Row], names: list[str]) -> float:
    """The error that the finest run still has, by the fitted orders (largest over the quantities `names`,
    keys added up), set as `floor` of every row measured against it. 0 where no order can be fitted."""
    floor = max((sum(o.left for o in orders(rows, name)) for name in names), default=0.0)
    for row in rows:
        row.floor = max(floor, NOTHING)
    return floor


def sentence(rows: list[Row], wanted: float, name: str = "") -> str:
    """What to use for an error of `wanted`, in words."""
    start = f"for {name}: " if name else ""
    taken = [row for row in rows if row.counts]
    if not taken:
        return f"{start}no run can be judged: none is complete besides the reference"
    good = [row for row in taken if row.worst + row.floor <= wanted * (1 + 1e-9)]
    if good:
        row = min(good, key=lambda r: (r.time_s, r.worst))
        return (f"{start}for an error of {100 * wanted:.3g} % use {row.point.label}, "
                f"it takes {_time(row)} (error {100 * row.worst:.2g} %)")
    row = min(taken, key=lambda r: (r.worst, r.time_s))
    return (f"{start}no run reaches an error of {100 * wanted:.3g} %; the nearest is {row.point.label} "
            f"with {100 * row.worst:.2g} %, it takes {_time(row)}")


def _time(row: Row) -> str:
    noise = f" +- {row.time_spread_s / 2:.2g} s" if row.time_spread_s else ""
    short = f"{row.time_s:.2g} s" if row.time_s < 10 else duration(row.time_s)
    if row.by == "processor":
        return f"{short}{noise} of processor time"
    return f"{short}{noise}, {row.core_s:.3g} core seconds"
