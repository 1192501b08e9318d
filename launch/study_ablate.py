"""Optional terms of a scene, each with the setting that turns it off, for `study --ablate`."""

from __future__ import annotations

from launch import schema
from launch.case import Case
from launch.study_points import Point

# Name, key, value that turns it off, or what becomes of the case's value. A term counts where slidewave
# knows the key (for parameters: where the case has it) and the case does not already leave it out.
TERMS: tuple[tuple[str, str, object], ...] = (
    ("drag", "models.drag", "none"),
    ("pressure-gradient force", "models.pressure_gradient", False),
    ("reaction on the fluid", "coupling.reaction", "one_way"),
    ("virtual mass", "models.virtual_mass", "none"),
    ("viscous-stress force", "models.viscous_force", False),
    ("lift", "models.lift", "none"),
    ("torque", "models.torque", "none"),
    ("turbulence", "models.turbulence", "none"),
    ("coarse graining of drag", "parameters.coarse_grain", 1),
    ("surface tension", "parameters.surface_tension", 0),
    ("contact damping", "parameters.damping", 0),
    ("rolling resistance", "parameters.rolling_friction", 0),
    ("rolling resistance", "parameters.rolling_shape", 0),
    ("nine tenths of the air's mass", "parameters.air_density", lambda density: density / 10),
)
BASE = "as it is"


def points(case: Case) -> list[Point]:
    """The case as it is, then one point for each term that it has, without that term."""
    found = [Point((), BASE)]
    for name, key, value in TERMS:
        off = value(case.get(key)) if callable(value) and case.get(key) is not None else value
        if key.startswith("parameters."):
            present = case.get(key) is not None
        else:
            known = schema.find_key(key)
            present = known is not None and schema.fault(known, off) is None
            present = present and case.get(key) is not None
        if present and case.get(key) != off:
            found.append(Point(((key, _text(off)),), f"without {name}"))
    return found


def _text(value: object) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)
