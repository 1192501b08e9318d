"""Runs of the cases in cases/verification: started from the command line's own code, read from their
files, and noted for verification.json."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
import time
import unittest
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from launch import cli, places, results, verification
from launch.places import ROOT


@dataclass
class Run:
    """A finished run: history.csv, summary.json, directory, wall time [s]."""

    directory: Path
    history: dict[str, np.ndarray]
    summary: dict
    wall_s: float

    def field(self, name: str, time_name: str | None = None) -> np.ndarray:
        """Cell values of an ascii field, (cells,) or (cells, 3); of the last time written by default."""
        fluid = self.directory / "fluid"
        times = [d for d in fluid.iterdir() if re.fullmatch(r"[0-9.e-]+", d.name) and d.name != "0"]
        place = fluid / time_name if time_name else max(times, key=lambda d: float(d.name))
        text = (place / name).read_text()
        inside = text[text.index("internalField"):text.index("boundaryField")]
        width = 3 if "volVectorField" in text else 1
        if "nonuniform" not in inside:
            numbers = inside[inside.index("uniform") + 7:]
        else:
            numbers = inside[inside.index("\n("):]
        values = np.array(re.sub(r"[();]", " ", numbers).split(), dtype=float).reshape(-1, width)
        return values if width == 3 else values[:, 0]

    def probe(self, name: str) -> np.ndarray:
        """What the function object `probes` saw: (steps, 1 + components of all probes), time first."""
        (path,) = self.directory.glob(f"fluid/postProcessing/probes/*/{name}")
        rows = [re.sub(r"[()]", " ", line).split() for line in path.read_text().splitlines()
                if not line.startswith("#")]
        return np.array(rows, dtype=float)


class Verification(unittest.TestCase):
    """A test that runs verification cases."""

    def run_case(self, case: str, *words: str, expect: int = 0, force: bool = False,
                 **settings: object) -> Run:
        """Runs cases/verification/<case> with settings (a__b means the key a.b)."""
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        out = Path(holder.name).resolve() / "run"
        command = ["run", str(ROOT / "cases/verification" / case), "--out", str(out), *words]
        for key, value in settings.items():
            command += ["--set", f"{key.replace('__', '.')}={value}"]
        start = time.monotonic()
        status = cli.main(command + (["--force"] if force else []))
        summary = results.read_summary(out)
        self.assertEqual(status, expect, summary.get("reason"))
        return Run(out, results.read_history(out), summary, time.monotonic() - start)

    def packed(self, case: str, **variables: object) -> Path:
        """A copy of cases/verification/<case> with the grains as its dem/in.pack leaves them."""
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        copy = Path(holder.name).resolve() / "case"
        shutil.copytree(ROOT / "cases/verification" / case, copy)
        given = [word for name, value in variables.items() for word in ("-var", name, str(value))]
        subprocess.run([places.program("slidewave_dem"), "--script", "in.pack", "-log", "none", *given],
                       cwd=copy / "dem", check=True, stdout=subprocess.DEVNULL, timeout=600)
        return copy

    def near(self, case: str, quantity: str, value: float, reference: float, tolerance: float,
             run: Run, absolute: bool = False) -> None:
        """Notes one comparison and demands it: error relative to the reference, or `absolute`."""
        verification.record(case, quantity, float(value), float(reference), tolerance, run.wall_s, absolute)
        scale = 1.0 if absolute or reference == 0 else abs(reference)
        self.assertLessEqual(abs(value - reference) / scale, tolerance,
                             f"{case}: {quantity} is {value:.8g}, not {reference:.8g}")

    def budgets_close(self, case: str, run: Run) -> None:
        """Momentum given is momentum received to 1e-10; the solid's volume is kept to 1e-12."""
        budgets = run.summary["budgets"]
        self.near(case, "momentum defect", budgets["momentum_defect"], 0, 1e-10, run)
        self.near(case, "solid volume defect", budgets["solid_volume_defect"], 0, 1e-12, run)
