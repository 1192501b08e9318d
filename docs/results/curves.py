"""What the small result scripts of this directory share: a CSV of points, and lines in a picture."""

from __future__ import annotations

import csv
from pathlib import Path

import matplotlib
from matplotlib.figure import Figure

HERE = Path(__file__).resolve().parent
Row = dict[str, object]


def write_csv(name: str, rows: list[Row]) -> None:
    """NAME.csv beside this file, numbers with four digits."""
    with (HERE / f"{name}.csv").open("w", newline="", encoding="utf-8") as stream:
        table = csv.DictWriter(stream, list(rows[0]), lineterminator="\n")
        table.writeheader()
        for row in rows:
            table.writerow({k: f"{v:.4g}" if isinstance(v, float) else v for k, v in row.items()})


def draw(name: str, rows: list[Row], panels: list[str], across: str, up: str, lines: str, title: str) -> None:
    """NAME.svg: `up` over `across`, both logarithmic, a panel for each value of rows["panel"] in
    `panels`, a line for each value of the column `lines`."""
    drawing = Figure(figsize=(5.2 * len(panels), 4.2), layout="constrained")
    drawing.suptitle(title, fontsize=10)
    for number, panel in enumerate(panels):
        axes = drawing.add_subplot(1, len(panels), number + 1)
        here = [r for r in rows if r["panel"] == panel and r[up] == r[up]]
        for value in dict.fromkeys(r[lines] for r in here):
            line = [r for r in here if r[lines] == value]
            axes.plot([r[across] for r in line], [max(r[up], 1e-7) for r in line], "o-", markersize=3, linewidth=1,
                      label=f"{value:g}" if isinstance(value, float) else str(value))
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_xlabel(across, fontsize=8)
        axes.set_ylabel(up, fontsize=8)
        axes.set_title(panel, fontsize=9)
        axes.tick_params(labelsize=7, which="both")
        axes.grid(alpha=0.3)
        axes.legend(fontsize=7, title=lines, title_fontsize=7)
    with matplotlib.rc_context({"svg.hashsalt": "slidewave", "svg.fonttype": "none"}):
        drawing.savefig(HERE / f"{name}.svg", format="svg", metadata={"Date": None})
