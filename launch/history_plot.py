"""Time histories: one panel a quantity, with the targets of the case drawn where they belong."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from launch.results import BOOKKEEPING, plain_name, unit_of

MOST_PANELS = 12
LAST = ("defect", "given", "received", "ledger", "momentum", "steps", "solid_spread")  # bookkeeping


def figure(history: dict[str, np.ndarray], targets: list[dict], first: list[str]) -> Figure | None:
    """Panels of the columns that vary: those of the targets, then `first`, then the others."""
    if not history or len(history.get("time_s", ())) < 2:
        return None
    named = [t["column"] for t in targets] + first
    columns = [c for c in dict.fromkeys(named + list(history)) if c in history and c not in BOOKKEEPING]
    columns = [c for c in columns if c in named or _varies(history[c])]
    columns.sort(key=lambda c: c not in named and any(word in c for word in LAST))  # stable
    columns = columns[:MOST_PANELS]
    if not columns:
        return None
    across = min(3, len(columns))
    down = -(-len(columns) // across)
    drawing = Figure(figsize=(11.0, 2.6 * down), layout="constrained")
    for number, column in enumerate(columns):
        axes = drawing.add_subplot(down, across, number + 1)
        axes.plot(history["time_s"], history[column], color="#1f5f99", linewidth=1.2)
        for target in (t for t in targets if t["column"] == column):
            _mark(axes, target)
        axes.set_title(plain_name(column), fontsize=9)
        axes.set_ylabel(f"[{unit_of(column) or '-'}]", fontsize=8)
        axes.set_xlabel("time [s]", fontsize=8)
        axes.tick_params(labelsize=7)
        axes.grid(alpha=0.3)
    return drawing


def _varies(values: np.ndarray) -> bool:
    values = values[np.isfinite(values)]
    return values.size > 1 and bool(np.ptp(values) > 0)


def _mark(axes, target: dict) -> None:
    """The reference as a dashed line with its tolerance as a band."""
    reference = target["reference"]
    half = min((limit for limit in (target.get("tolerance_absolute"),
                                    (target.get("tolerance") or np.inf) * abs(reference))
                if limit is not None and np.isfinite(limit)), default=0.0)
    colour = "#2a7f3f" if target["pass"] else "#b03a2e"
    if target["reduce"] == "time_of_max":
        axes.axvline(reference, color=colour, linestyle="--", linewidth=1)
        axes.axvspan(reference - half, reference + half, color=colour, alpha=0.12, linewidth=0)
    else:
        axes.axhline(reference, color=colour, linestyle="--", linewidth=1)
        axes.axhspan(reference - half, reference + half, color=colour, alpha=0.12, linewidth=0)
