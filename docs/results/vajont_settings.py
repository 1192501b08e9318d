#!/usr/bin/env python3
"""Regenerates vajont_settings.csv, vajont_steps.csv, vajont_terms.csv and their pictures beside this file
(an hour of two cores; two points at a time):

    /usr/bin/python3 docs/results/vajont_settings.py [settings|steps|terms]

Section A-A of Vajont, quick. settings: one setting at a time from the start to 20 s, past the peaks of slide and
wave, compared with the case as it is; seed is another packing: the noise of the answer. steps: the paper's own
steps over the first second. terms: each optional term left out of the variant that has them all, to 18 s. Run
time is the processor time that the ranks worked: other work on the machine hardly counts.
"""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(ROOT))
os.environ.setdefault("SLIDEWAVE_BUILD", str(ROOT / "build"))

from launch import cli  # noqa: E402

PLACE = ROOT / "runs/vajont_settings"
COMMON = ["study", "vajont_east", "--ranks-fluid", "1", "--ranks-dem", "1", "--jobs", "2", "--force",
          "--time", "processor", "--set", "output.interval=1"]
PEAKS = ["--quantity", "max:slide_speed_m_s", "--quantity", "curve:slide_speed_m_s", "--quantity", "max:wave_speed_m_s",
         "--quantity", "max:wave_height_m"]
# Keys in the first line; an empty cell leaves the case's value. The first point is the case as it is.
SETTINGS = """coupling.window,coupling.regime,coupling.scheme,parameters.dem_dt,parameters.kn,parameters.kt,geometry.cell_size,coupling.smoothing_length,parameters.d_min,parameters.d_max,parameters.coarse_grain,geometry.seed
0.02,,,,,,,,,,,
,,,,,,,,,,,2
0.04,,,,,,,,,,,
0.01,,,,,,,,,,,
,,,,,,12,,,,,
,,,4e-3,,,,,7.2,15.2,4,
,,,2.8e-3,1e9,9e8,,,,,,
,,,4e-3,3e8,2.7e8,,,,,,
,stiff,,,,,,,,,,
,,concurrent,,,,,,,,,
,,,,,,,24,,,,
,,,2e-3,,,,,,,,
,,,,,,6,,,,,
,,,8e-4,,,,,,,,
"""
STEPS = """coupling.window,parameters.dem_dt,parameters.fluid_dt,parameters.fluid_adjust
0.02,1.6e-3,0.005,yes
0.005,4e-4,0.005,yes
1e-3,1e-5,1e-3,no
"""


def publish(name: str, status: int) -> int:
    """Copies a study's files here."""
    for kind in ("csv", "svg"):
        shutil.copyfile(PLACE / name / f"study.{kind}", HERE / f"vajont_{name}.{kind}")
    return status


def settings() -> int:
    """One setting at a time, against the case as it is."""
    (PLACE / "settings.list.csv").write_text(SETTINGS)
    (PLACE / "base.list.csv").write_text("".join(SETTINGS.splitlines(keepends=True)[:2]))
    out = ["--out", str(PLACE / "settings"), "--set", "case.end_time=20", *PEAKS]
    cli.main([*COMMON, *out, "--list", str(PLACE / "base.list.csv")])
    (base,) = (PLACE / "settings/points").glob("window_0.02-*/history.csv")
    shutil.copyfile(base, PLACE / "base_history.csv")
    return publish("settings", cli.main([*COMMON, *out, "--list", str(PLACE / "settings.list.csv"),
                                         "--reference", str(PLACE / "base_history.csv")]))


def steps() -> int:
    """The paper's steps over one second: the costliest run is the reference."""
    (PLACE / "steps.list.csv").write_text(STEPS)
    return publish("steps", cli.main([*COMMON, "--out", str(PLACE / "steps"), "--set", "case.end_time=1",
                                      "--list", str(PLACE / "steps.list.csv"), "--quantity", "curve:slide_speed_m_s"]))


def terms() -> int:
    """Each optional term left out."""
    return publish("terms", cli.main([*COMMON, "--out", str(PLACE / "terms"), "--variant", "all_terms",
                                      "--set", "case.end_time=18", "--ablate", *PEAKS]))


def main() -> int:
    """Runs the studies named, or all."""
    PLACE.mkdir(parents=True, exist_ok=True)
    known = {"settings": settings, "steps": steps, "terms": terms}
    return max(known[name]() for name in (sys.argv[1:] or known))


if __name__ == "__main__":
    sys.exit(main())
