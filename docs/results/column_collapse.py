#!/usr/bin/env python3
"""Regenerates column_collapse.csv and .svg beside this file: stiffness, step and coarse graining of a dry
column collapse (ten minutes)

    /usr/bin/python3 docs/results/column_collapse.py

A column of height 1 and length 1 in a thin slab (tests/dem_side/column_collapse.py) runs out. One of
stiffness, particle step and grain size is varied at a time; the error is that of the run-out against the
mean of three packings of the finest values. The scatter of those three is the noise of the answer.
"""

from __future__ import annotations

import os
import statistics
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "docs/results")]
os.environ.setdefault("SLIDEWAVE_DEM", str(ROOT / "build/bin/slidewave_dem"))

import matplotlib  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402

import curves  # noqa: E402
from tests.dem_side.column_collapse import collapse  # noqa: E402

LENGTH, SAND = 20.0, "shape 0.4 crushing 2.1"
BASE = {"kn over weight/D": 1000.0, "step over sqrt(m/kn)": 0.2, "alpha": 1.0}
VARIED = {"kn over weight/D": (30.0, 100.0, 300.0, 1000.0, 3000.0), "step over sqrt(m/kn)": (0.8, 0.6, 0.45, 0.3, 0.2, 0.1),
          "alpha": (4.0, 2.0, 1.0)}
SEEDS = (3, 4, 5)


def runs_out(point: dict[str, float], seed: int) -> tuple[float, float]:
    """Run-out over the length, and run time [s]; nan where the run ends itself."""
    with tempfile.TemporaryDirectory() as place:
        try:
            seen = collapse(Path(place), 1.0, LENGTH, point["alpha"], rolling=SAND, stiffness=point["kn over weight/D"],
                            step=point["step over sqrt(m/kn)"], seed=seed)
        except RuntimeError:
            return float("nan"), float("nan")
        return seen.run_out, seen.wall_s


def draw(rows: list[curves.Row], base: float, noise: float) -> None:
    """Run-out against run time, a panel a key, each point with its value; the band is the packings' scatter."""
    drawing = Figure(figsize=(5.2 * len(VARIED), 4.2), layout="constrained")
    drawing.suptitle("dry column collapse, one key at a time; band: scatter of three packings", fontsize=10)
    for number, key in enumerate(VARIED):
        axes = drawing.add_subplot(1, len(VARIED), number + 1)
        axes.axhspan(base * (1 - noise), base * (1 + noise), color="#1f5f99", alpha=0.15)
        for row in (r for r in rows if r["panel"] == key and r["run-out"] == r["run-out"]):
            axes.plot(row["run time [s]"], row["run-out"], "o", markersize=4, color="#1f5f99")
            axes.annotate(f"{row['value']:g}", (row["run time [s]"], row["run-out"]), fontsize=7, xytext=(4, 4),
                          textcoords="offset points")
        axes.set_xscale("log")
        axes.set_xlabel("run time [s]", fontsize=8)
        axes.set_ylabel("run-out over the column's length", fontsize=8)
        axes.set_title(key, fontsize=9)
        axes.tick_params(labelsize=7, which="both")
        axes.grid(alpha=0.3)
        axes.margins(x=0.15, y=0.15)
    with matplotlib.rc_context({"svg.hashsalt": "slidewave", "svg.fonttype": "none"}):
        drawing.savefig(curves.HERE / "column_collapse.svg", format="svg", metadata={"Date": None})


def main() -> int:
    """Runs all points, writes both files."""
    base = [runs_out(BASE, seed) for seed in SEEDS]
    truth = statistics.mean(r for r, _ in base)
    noise = statistics.stdev(r for r, _ in base) / truth
    print(f"run-out {truth:.4g}, scatter of three packings {100 * noise:.2g} %")
    rows = []
    for key, values in VARIED.items():
        for value in values:
            seen = base if value == BASE[key] else [runs_out(BASE | {key: value}, seed) for seed in SEEDS]
            run_out = statistics.mean(r for r, _ in seen)
            error = noise if seen is base else abs(run_out / truth - 1)
            rows.append({"panel": key, "value": value, "run-out": run_out, "error": error, "scatter": noise,
                         "run time [s]": statistics.mean(t for _, t in seen)})
            print(*rows[-1].values(), flush=True)
    curves.write_csv("column_collapse", rows)
    draw(rows, truth, noise)
    return 0


if __name__ == "__main__":
    sys.exit(main())
