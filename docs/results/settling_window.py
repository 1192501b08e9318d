#!/usr/bin/env python3
"""Regenerates settling_window*.csv and .svg beside this file (minutes on two cores):

    docs/results/settling_window.py [DIR]       DIR keeps the runs (default runs/settling_window)

A sphere falls from rest at Re 100 (settling_sphere, variant re_100). Coupling window and particle
step are varied; the error is that of the speed over the whole fall. One-way runs are compared with
the equation of motion integrated apart (tests/cases/settling_ode.py), two-way runs with the finest. Schemes and
regimes (settling_schemes.csv) go two-way too, with the finest of the two-way runs as their reference.
"""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent))

from launch import case as cases  # noqa: E402
from launch import cli, places  # noqa: E402
from tests.cases.settling_ode import Sphere  # noqa: E402

WINDOWS = "coupling.window=0.0125,0.00625,0.003125,0.0015625"
SCHEMES = "coupling.scheme,coupling.regime\nserial,mild\nserial,stiff\nconcurrent,mild\n"
STEPS = "parameters.dem_dt=2e-4,1e-4"  # 4e-4 is three quarters of the critical step


def write_ode(path: Path) -> None:
    """Speed of the sphere over time, as a file for --reference."""
    case = cases.load("settling_sphere", "re_100")
    names = ("diameter", "solid_density", "fluid_density", "fluid_viscosity")
    sphere = Sphere(*(case.parameters[name] for name in names))
    times = np.linspace(0, case.get("case.end_time"), 1001)
    rows = [f"{t:.6g},{-v:.9g}" for t, v in zip(times, sphere.speed(times))]
    path.write_text("\n".join(["time_s,sphere_vz_m_s", *rows]) + "\n")


def main() -> int:
    """Runs both studies and copies their results here."""
    out = Path(sys.argv[1] if len(sys.argv) > 1 else places.ROOT / "runs/settling_window").absolute()
    out.mkdir(parents=True, exist_ok=True)
    os.environ.setdefault("SLIDEWAVE_BUILD", str(places.ROOT / "build"))
    write_ode(out / "settling_ode.csv")
    status = 0
    for reaction, reference, repeats, tail in (("one_way", str(out / "settling_ode.csv"), "3", ""),
                                               ("two_way", "best", "1", "_two_way")):
        status |= cli.main(["study", "settling_sphere", "--variant", "re_100", "--vary", WINDOWS,
                            "--vary", STEPS, "--set", f"coupling.reaction={reaction}",
                            "--set", "output.interval=0.25", "--quantity", "curve:sphere_vz_m_s",
                            "--reference", reference, "--repeat", repeats, "--ranks-fluid", "1",
                            "--ranks-dem", "1", "--out", str(out / reaction)])
        for kind in ("csv", "svg"):
            shutil.copyfile(out / reaction / f"study.{kind}", HERE / f"settling_window{tail}.{kind}")
    return status | schemes(out)


def schemes(out: Path) -> int:
    """Serial in both regimes and concurrent, over the windows."""
    (out / "schemes.list.csv").write_text(SCHEMES)
    (finest,) = (out / "two_way/points").glob("window_0.0015625-dem_dt_1e-4-*/history.csv")
    status = cli.main(["study", "settling_sphere", "--variant", "re_100", "--list", str(out / "schemes.list.csv"),
                       "--vary", WINDOWS, "--set", "coupling.reaction=two_way", "--set", "parameters.dem_dt=2e-4",
                       "--set", "output.interval=0.25", "--quantity", "curve:sphere_vz_m_s", "--reference", str(finest),
                       "--ranks-fluid", "1", "--ranks-dem", "1", "--time", "processor", "--force", "--out", str(out / "schemes")])
    for kind in ("csv", "svg"):
        shutil.copyfile(out / f"schemes/study.{kind}", HERE / f"settling_schemes.{kind}")
    return status


if __name__ == "__main__":
    sys.exit(main())
