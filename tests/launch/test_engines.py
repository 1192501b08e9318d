"""dem.engine chooses the particles' program; one that this machine lacks is refused before anything starts."""

import os
import unittest
from unittest import mock

import numpy as np

from launch import dem_script
from tests.launch.scratch import ScratchCase

LAMMPS = ("--variant", "uniform", "--set", "dem.engine=lammps", "--set", "dem.script=dem/in.lammps")
ESYS = ("--variant", "uniform", "--set", "dem.engine=esys", "--set", "dem.script=dem/sphere.py")


class Engines(ScratchCase):
    def setUp(self) -> None:
        super().setUp()
        (self.place / "bin").mkdir()
        holder = mock.patch.dict(os.environ, SLIDEWAVE_BUILD=str(self.place))
        holder.start()
        self.addCleanup(holder.stop)

    def test_missing_engine_names_its_package(self) -> None:
        for command in (("run", "--out", self.place / "run"), ("check",), ("submit", "--out", self.place / "run")):
            for engine, words in (("lammps", LAMMPS), ("esys", ESYS)):
                status, _, err = self.slidewave(command[0], self.case, *command[1:], *words)
                self.assertEqual(status, 2, err)
                for word in ("case.toml", "dem.engine", f"'{engine}'", f"slidewave_{engine}", "apt-get install",
                             "liblammps-dev" if engine == "lammps" else "esys-particle", "./slidewave setup"):
                    self.assertIn(word, err)
        self.assertFalse((self.place / "run").exists())

    def test_engine_chooses_the_program(self) -> None:
        (self.place / "bin/slidewave_lammps").touch()
        status, out, err = self.dry_run(*LAMMPS, "--ranks-dem", "3")
        self.assertEqual(status, 0, err)
        self.assertRegex(out, r"-np 1 \S*slidewave_uniform \S+ : -np 3 \S*slidewave_lammps \S+")
        status, out, err = self.slidewave("submit", self.case, "--dry-run", "--out", self.place / "job", *LAMMPS)
        self.assertEqual(status, 0, err)
        self.assertIn('-np 1 "$BIN/slidewave_lammps" "$RUN"', (self.place / "job/job.slurm").read_text())

    def test_esys_has_a_master_and_one_worker(self) -> None:
        (self.place / "bin/slidewave_esys").touch()
        status, out, err = self.dry_run(*ESYS)
        self.assertEqual(status, 0, err)
        self.assertRegex(out, r"-np 1 \S*slidewave_uniform \S+ : -np 2 \S*slidewave_esys \S+")
        status, _, err = self.dry_run(*ESYS, "--ranks-dem", "3", "--overwrite")
        self.assertEqual(status, 2)
        for word in ("--ranks-dem", "3", "2"):
            self.assertIn(word, err)

    def test_both_scripts_are_read_alike(self) -> None:
        ours, theirs = (dem_script.read(self.case / "dem" / name) for name in ("in.setup", "in.lammps"))
        for one, other in ((ours.box, theirs.box), (ours.positions, theirs.positions),
                           (ours.diameters, theirs.diameters), (ours.densities, theirs.densities)):
            np.testing.assert_array_equal(one, other)
        self.assertEqual((ours.stiffness_N_m, ours.gravity, ours.periodic),
                         (theirs.stiffness_N_m, theirs.gravity, theirs.periodic))


if __name__ == "__main__":
    unittest.main()
