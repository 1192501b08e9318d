"""coupling.scheme = "auto": concurrent where the pre-flight check proves it and each rank has a core, else serial."""

from __future__ import annotations

from launch import preflight, progress, ranks, scene_numbers
from launch.case import Case

SERIAL_ONLY = ("virtual_mass", "lift", "torque", "viscous_force")
RESPONSE = "drag on the fluid of a cell in a window, K W/m_fluid"


def choose(case: Case, ready: preflight.Prepared) -> None:
    """Puts "serial" or "concurrent" in the place of "auto". What is not known is taken for serial."""
    if case.get("coupling.scheme") != "auto":
        return
    concurrent = _worth_it(case, ready) and _proven(case, ready)
    case.put("coupling.scheme", "concurrent" if concurrent else "serial")
    if concurrent:
        progress.say("coupling.scheme: concurrent (windows are short enough, and each rank has a core)")


def _worth_it(case: Case, ready: preflight.Prepared) -> bool:
    both_sides = case.get("fluid.engine") == "openfoam" and case.get("dem.engine") != "none"
    return both_sides and ready.ranks_fluid + ready.ranks_dem <= ranks.cores()


def _proven(case: Case, ready: preflight.Prepared) -> bool:
    if case.get("coupling.regime") == "stiff" or case.get("models.drag") == "none":
        return False
    if case.get("models.formulation") != "A" or any(
            case.get(f"models.{name}") not in ("none", False, None) for name in SERIAL_ONLY):
        return False
    if case.get("coupling.reaction") == "one_way":
        return True  # nothing comes back
    rows = preflight.tool_findings(scene_numbers.collect(case, ready) | {"scheme": "concurrent"})
    known = any(row.quantity == RESPONSE and row.verdict == "ok" for row in rows)
    return known and not any(row.bad for row in rows)
