"""bench coupling and bench fluid on tiny scenes: they run, and give all the fields that were agreed."""

import math
import unittest
from unittest import mock

from launch import bench_coupling, bench_fluid

ROW = {"n", "ranks", "exchange_ns", "locate_ns", "void_fraction_ns", "force_ns", "total_ns",
       "bytes_per_particle"}


class Bench(unittest.TestCase):
    def test_coupling_gives_a_row_with_every_field(self) -> None:
        with mock.patch.object(bench_coupling, "_of_few", lambda count: (0, 0.0)):
            row = bench_coupling.row("n1e4", 1, windows=(1, 4), settings=bench_coupling.FEW)
        self.assertLessEqual(ROW, set(row))
        self.assertEqual((row["n"], row["ranks"]), (196, 1))
        self.assertTrue(all(math.isfinite(value) for value in row.values()), row)
        parts = sum(row[name] for name in bench_coupling.PHASES)
        self.assertAlmostEqual(row["total_ns"], parts)
        self.assertGreater(row["total_ns"], 0)

    def test_fluid_compares_equal_numbers_of_steps(self) -> None:
        few = {"two_fluids": ("parameters.cells_x=8", "parameters.cells_z=8"),
               "one_fluid": ("parameters.cells=4", "parameters.cells_high=4")}
        for name, settings in few.items():
            numbers = bench_fluid.compare(name, 1, (10, 30), settings)
            self.assertTrue(all(map(math.isfinite, numbers.values())), numbers)  # too short to say more
            self.assertEqual(set(numbers), {f"ratio_{name}", f"{name}_own_s",
                                            f"{name}_{bench_fluid.SCENES[name].solver}_s"})


if __name__ == "__main__":
    unittest.main()
