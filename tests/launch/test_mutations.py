"""Broken inputs by the hundred: each is refused with a reason, or it runs to a result; never a hang, a traceback,
a crash that nobody explains, or numbers that are none.

SLIDEWAVE_MUTANTS: how many (default 60; 500 in the full test). SLIDEWAVE_MUTANT: one number, to look at."""

import math
import os
import shutil
import shlex
import subprocess
import tempfile
import time
import traceback
import unittest
from pathlib import Path

from launch import case as cases
from launch import places, prepare, results
from launch.errors import InputError
from tests.launch.mutate import mutate
from tests.launch.scratch import command_line

COUNT = int(os.environ.get("SLIDEWAVE_MUTANTS", "60"))
ONE = os.environ.get("SLIDEWAVE_MUTANT")
NUMBERS = [int(ONE)] if ONE else range(COUNT)
LONGEST_S = 60  # one run
ALL_S = 130 if COUNT <= 60 else 2400
RUNS = int(os.environ.get("SLIDEWAVE_MUTANT_RUNS", "12" if COUNT <= 60 else str(COUNT)))  # of those that prepare well
FLUID = [f"fluid/{name}" for name in ("0/U", "0/p", "constant/g", "constant/transportProperties",
                                      "constant/turbulenceProperties", "system/blockMeshDict", "system/controlDict",
                                      "system/fvSchemes", "system/fvSolution")]
# Variant and files of a short run: a prescribed flow for most, OpenFOAM for its own dictionaries.
SHORT = ("case.end_time=0.002", "output.interval=0.002")
KINDS = (("uniform", ["case.toml", "dem/in.setup"]), ("uniform", ["case.toml"]), ("one_way", FLUID))


class Mutations(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.place = Path(holder.name).resolve()

    def copy(self, name: str) -> Path:
        case = self.place / name
        shutil.rmtree(case, ignore_errors=True)
        shutil.copytree(places.ROOT / "cases" / name, case)
        return case

    def test_short_runs(self) -> None:
        begin, wrong = time.monotonic(), []
        seen = dict.fromkeys(("refused", "prepared", "failed", "ran"), 0)
        for number in NUMBERS:
            if time.monotonic() - begin > ALL_S:
                print(f"stopped in time after {number} of {COUNT}")
                break
            variant, files = KINDS[number % len(KINDS)]
            what = mutate(self.copy("settling_sphere"), files, number)
            fault = self.fault_of(variant, seen)
            if fault:
                wrong.append(f"mutant {number} ({variant}), {what}\n{fault}")
        print(seen)
        self.assertFalse(wrong, f"{len(wrong)} wrong:\n" + "\n\n".join(wrong))

    def fault_of(self, variant: str, seen: dict[str, int]) -> str | None:
        """What is wrong with how one mutant ends; None where nothing is."""
        out = self.place / "run"
        shutil.rmtree(out, ignore_errors=True)
        words = ["run", self.place / "settling_sphere", "--variant", variant, "--out", out, "--dry-run",
                 *(w for s in SHORT for w in ("--set", s))]
        try:
            status, text, err = command_line(*words)
        except Exception:  # what must not happen
            return traceback.format_exc()[-1500:]
        if status:
            seen["refused"] += 1
            reasoned = status in (1, 2) and err.startswith("slidewave: ")
            return None if reasoned else f"status {status}: {text[-400:]} {err[-400:]}"
        if seen["ran"] + seen["failed"] >= RUNS:
            seen["prepared"] += 1
            return None
        line = shlex.split(next(line for line in text.splitlines() if line.startswith("mpirun ")))
        return self.fault_of_run(line, out, seen)

    def fault_of_run(self, line: list[str], out: Path, seen: dict[str, int]) -> str | None:
        try:
            done = subprocess.run(line, capture_output=True, text=True, timeout=LONGEST_S, errors="replace",
                                  env=places.openfoam_environment(), check=False)
        except subprocess.TimeoutExpired as error:
            return f"hangs: {str(error.stdout)[-800:]}"
        if done.returncode == 0:
            seen["ran"] += 1
            return self.fault_of_result(out)
        seen["failed"] += 1
        if done.returncode in (1, 2) and "slidewave: " in done.stderr and (out / "failure.txt").is_file():
            return None
        return f"status {done.returncode} without a reason: {(done.stdout + done.stderr)[-800:]}"

    def fault_of_result(self, out: Path) -> str | None:
        history = results.read_history(out)
        for name, column in history.items():
            if not all(math.isfinite(v) for v in column):
                return f"history.csv has no number in {name}"
        if "sphere_vz_m_s" in history and abs(history["sphere_vz_m_s"][-1]) > 1:
            return "the sphere flies"
        return None

    def test_big_cases_are_read(self) -> None:
        """The larger cases, read and checked without being prepared: thousandths of a second each."""
        wrong = []
        for number in NUMBERS:
            for name in ("vajont_east", "vajont_west"):
                case = self.copy(name)
                files = ["case.toml", "dem/in.setup", "fluid/system/controlDict", "fluid/constant/transportProperties"]
                what = mutate(case, files, 100_000 + number)
                try:
                    prepare.check_input(cases.load(str(case)))
                except InputError as error:
                    if not error.file or not error.key or not error.remedy:
                        wrong.append(f"{name} {number}, {what}: {error}")
                except Exception as error:  # what must not happen
                    wrong.append(f"{name} {number}, {what}: {type(error).__name__} {error}")
        self.assertFalse(wrong, f"{len(wrong)} wrong:\n" + "\n".join(wrong))


if __name__ == "__main__":
    unittest.main()
