#!/usr/bin/env python3
"""Regenerates stiff_window.csv and .svg beside this file: window against error for drag of any stiffness (minutes)

    /usr/bin/python3 docs/results/stiff_window.py

A free suspension (slip against the drag law integrated apart) and a held bed (flow against Darcy's). x = K W/m of
the longest window; it is cut to a half and a quarter. The regime is what coupling.regime = "auto" chooses.
"""

from __future__ import annotations

import os
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "docs/results")]
os.environ.setdefault("SLIDEWAVE_BUILD", str(ROOT / "build"))

import curves  # noqa: E402
from tests.cases.stability.columns import held, suspension  # noqa: E402
from tests.cases.stability.trial import attempt  # noqa: E402

STIFFNESSES = (1e-2, 1e-1, 1.0, 10.0, 100.0, 1e3, 1e4)
CUTS = (1, 2, 4)
WINDOW, LONGEST = 1e-3, 400


def scene(kind: str, x: float, cut: int):
    """The scene whose longest window has this stiffness, with the window cut."""
    if kind == "free suspension":  # five response times of the mixture, or ten windows
        windows = min(LONGEST, max(10, round(5 / x / 2.14)))
        return suspension(kind, f"{x:g}, {cut}", x=x / cut, window=WINDOW / cut, windows=windows * cut)
    return held(kind, f"{x:g}, {cut}", x=x / cut, window=WINDOW / cut, ratio=2.65,
                windows=min(LONGEST, max(12, round(12 / x**0.5))) * cut)


def main() -> int:
    """Runs all points, writes both files."""
    rows = []
    for kind, smallest in (("free suspension", 1e-2), ("held bed", 1e-1)):
        for x in (s for s in STIFFNESSES if s >= smallest):
            for cut in CUTS:
                with tempfile.TemporaryDirectory() as place:
                    seen = attempt(scene(kind, x, cut), Path(place).resolve() / "run")
                rows.append({"panel": kind, "K W/m at first": x, "window over the longest": 1 / cut,
                             "error": seen.error, "run time [s]": seen.wall_s, "stable": int(seen.stable),
                             "check": seen.verdict})
                print(*rows[-1].values(), seen.why, flush=True)
    curves.write_csv("stiff_window", rows)
    curves.draw("stiff_window", rows, ["free suspension", "held bed"], "run time [s]", "error", "K W/m at first",
                "window cut to a half and a quarter, for drag of any stiffness")
    return 0


if __name__ == "__main__":
    sys.exit(main())
