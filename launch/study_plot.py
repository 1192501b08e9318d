"""study.svg: error against run time, a panel a quantity, the Pareto front labelled."""

from __future__ import annotations

from pathlib import Path

import matplotlib
from matplotlib.figure import Figure
from matplotlib.ticker import FormatStrFormatter, LogLocator, NullFormatter

from launch.study_analysis import front
from launch.study_quantities import Quantity
from launch.study_results import Row

COLOURS = ("#1f5f99", "#b03a2e", "#2a7f3f", "#8e5bb5", "#b07d1f", "#444444")
MARKERS = "osD^vP"
SMALLEST = 1e-9  # errors below are drawn hollow, at the bottom


def write(path: Path, title: str, groups: dict[str, list[Row]], quantities: list[Quantity],
          all_labels: bool = False) -> None:
    """Draws every group in its own colour; `all_labels` names each point, not only the front's."""
    across = min(2, len(quantities))
    down = -(-len(quantities) // across)
    drawing = Figure(figsize=(6.4 * across, 4.6 * down), layout="constrained")
    drawing.suptitle(title, fontsize=10)
    for number, quantity in enumerate(quantities):
        axes = drawing.add_subplot(down, across, number + 1)
        for index, (name, rows) in enumerate(groups.items()):
            _draw(axes, rows, quantity.name, name, index, all_labels)
        axes.set_xscale("log")
        axes.set_yscale("log")
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
            axis.set_major_formatter(FormatStrFormatter("%g"))
            axis.set_minor_formatter(NullFormatter())
        by = next((row.by for rows in groups.values() for row in rows), "wall")
        axes.set_xlabel("run time [s]" if by == "wall" else "processor time [s]", fontsize=8)
        axes.set_ylabel(f"error of {quantity.name} [-] (hollow: below {SMALLEST:g})", fontsize=8)
        axes.tick_params(labelsize=7, which="both")
        axes.grid(alpha=0.3)
        axes.margins(x=0.25, y=0.1)
        if axes.get_legend_handles_labels()[0]:
            axes.legend(fontsize=7, loc="lower left")
    with matplotlib.rc_context({"svg.hashsalt": "slidewave", "svg.fonttype": "none"}):
        drawing.savefig(path, format="svg", metadata={"Date": None})


def _draw(axes, rows: list[Row], quantity: str, name: str, index: int, all_labels: bool) -> None:
    """Points of one group, its front as a line, its labels beside it."""
    taken = [row for row in rows if row.counts and quantity in row.errors]
    if not taken:
        return
    colour = COLOURS[index % len(COLOURS)]
    costs = [max(row.time_s, 1e-3) for row in taken]
    seen = [row.errors[quantity] for row in taken if row.errors[quantity] > SMALLEST]
    bottom = min(seen) / 3 if seen else SMALLEST
    errors = [max(row.errors[quantity], bottom) for row in taken]
    spread = [row.time_spread_s / 2 for row in taken]
    axes.errorbar(costs, errors, xerr=spread if any(spread) else None, fmt=MARKERS[index % len(MARKERS)],
                  color=colour, markersize=4, elinewidth=0.7, label=name or None)
    for cost, row, error in zip(costs, taken, errors):
        if row.errors[quantity] <= SMALLEST:
            axes.plot(cost, error, MARKERS[index % len(MARKERS)], color="white", markersize=2.5, zorder=3)
    best = front(costs, errors)
    if not all_labels:
        axes.plot([costs[i] for i in best], [errors[i] for i in best], color=colour, linewidth=1)
    for i in range(len(taken)) if all_labels else best:
        right = costs[i] ** 2 > min(costs) * max(costs)  # its label goes to the left, into the picture
        axes.annotate(taken[i].point.label, (costs[i], errors[i]), fontsize=6, color=colour,
                      xytext=(-4 if right else 4, 4), ha="right" if right else "left",
                      textcoords="offset points")
