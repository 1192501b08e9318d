"""Slides: the first wave of a granular slide, and how far it runs.

References: Heller and Hager (2010), a_M/h = 4/9 P^(4/5) at x_M/h = 11/2 P^(1/2) off the shore, with the impulse
product P of the slide where it meets the water; Viroulet et al. (2014): water shortens the run-out."""

import math
import os
import unittest

from tests.cases.verification import spheres
from tests.cases.verification.runs import Run, Verification

FULL = "SLIDEWAVE_VERIFICATION" in os.environ


class SlideWave(Verification):
    """Amplitude at the gauge next to x_M (nearer to the shore is splash), 30 %: the scatter of the experiments about
    the formula. Their ramp goes on under water, ours ends at the shore."""

    depth, width, spacing, quay, g = 0.3, 0.0291681, 0.0145841, 0.525, 9.81

    def impulse_product(self, run: Run, layers: int) -> float:
        """Of the speed that the slide has reached at the shore, its thickness and its mass."""
        speed = run.history["slide_speed_m_s"].max()
        mass = run.summary["particles"] * 2650.0 * spheres.volume(0.0143)
        froude = speed / math.sqrt(self.g * self.depth)
        thickness, share = layers * self.spacing / self.depth, mass / (1000 * self.width * self.depth**2)
        return froude * math.sqrt(thickness) * share**0.25 * math.sqrt(math.cos(6 / 7 * math.pi / 4))

    def slides(self, speed: float, layers: int) -> tuple[float, float, Run]:
        """Impulse product, amplitude over depth, run."""
        run = self.run_case("slide_wave", parameters__slide_speed=speed, parameters__layers=layers)
        product = self.impulse_product(run, layers)
        place = round(5.5 * math.sqrt(product))  # gauges stand at 3 to 8 depths
        highest = run.history[f"gauge_{place}_level_m"].max() / self.depth - 1
        case = f"slide_wave, {speed:g} m/s, {layers} layers"
        self.near(case, f"amplitude over depth at P {product:.2f}", highest, 4 / 9 * product**0.8, 0.3, run)
        self.near(case, "water volume defect", run.history["water_volume_defect"].max(), 0, 1e-6, run)
        self.budgets_close(case, run)
        return product, highest, run

    def test_wave_and_run_out(self) -> None:
        _, _, wet = self.slides(3, 7)
        dry = self.run_case("slide_wave", "--variant", "dry")
        run_outs = [r.history["slide_front_x_m"][-1] - self.quay for r in (wet, dry)]
        self.near("slide_wave, 3 m/s, 7 layers", "run-out in water over that without, above 1",
                  max(0.0, run_outs[0] / run_outs[1] - 1), 0, 1e-9, wet)
        print(f"run-out {run_outs[0]:.3f} m in water, {run_outs[1]:.3f} m without")

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        found = sorted(self.slides(*slide)[:2] for slide in ((2, 7), (3, 7), (4, 7), (4, 11)))
        heights = [height for _, height in found]
        self.assertEqual(heights, sorted(heights), "a larger impulse product, a higher wave")


if __name__ == "__main__":
    unittest.main()
