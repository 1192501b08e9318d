"""The calibration of both engines: it is measured once for a build, and the check says so."""

import os
import tempfile
import unittest
from unittest import mock

from launch import calibration


class Calibration(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        patch = mock.patch.dict(os.environ, {"SLIDEWAVE_CACHE": holder.name})
        patch.start()
        self.addCleanup(patch.stop)

    def test_measured_once(self) -> None:
        self.assertEqual(calibration.unit_costs(True, measure=False), {})
        first = calibration.unit_costs(True, measure=True)
        self.assertEqual(set(first), {"particle_steps_per_s", "cell_steps_per_s"})
        self.assertGreater(first["particle_steps_per_s"], 1e5)
        self.assertLess(first["particle_steps_per_s"], 1e8)
        self.assertGreater(first["cell_steps_per_s"], 1e4)
        with mock.patch.object(calibration, "_measured", side_effect=AssertionError("measured again")):
            self.assertEqual(calibration.unit_costs(True, measure=True), first)

    def test_a_new_build_is_measured_again(self) -> None:
        with mock.patch.object(calibration, "_measured", return_value=1e6), \
                mock.patch.object(calibration, "_builds", return_value={"a": [1, 2]}):
            calibration.unit_costs(False, measure=True)
        self.assertEqual(calibration.unit_costs(False, measure=False), {})

    def test_what_does_not_run_is_left_out(self) -> None:
        with mock.patch.object(calibration, "_measured", return_value=None):
            self.assertEqual(calibration.unit_costs(True, measure=True), {})


if __name__ == "__main__":
    unittest.main()
