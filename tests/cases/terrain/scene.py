"""The two Vajont sections as the tests use them, with the figures of their definition."""

from dataclasses import dataclass

from launch.places import ROOT
from launch.terrain.profile import read_section

LAKE = 700.42
D_MAX = 7.6  # of quick [m]
CELL = 8.0  # of quick [m]


@dataclass(frozen=True)
class Figures:
    """Published figures of a section's definition: areas in m2, thickness in m."""

    slide_area: float
    mean_thickness: float
    largest_thickness: float
    below_lake: float
    water_area: float
    water_width: float
    water_depth: float


FIGURES = {
    "east": Figures(155225, 132, 229, 0.21, 44845, 410, 210),
    "west": Figures(115470, 131, 220, 0.28, 40640, 355, 235),
}


def section(name):
    """The section of cases/vajont_<name> with quick's margins."""
    return read_section(ROOT / f"cases/vajont_{name}/geometry/profile.toml", LAKE, 3 * D_MAX)
