"""coupling.regime = "auto": mild where the pre-flight check proves it, else stiff."""

from __future__ import annotations

from launch import preflight, progress, scene_numbers
from launch.case import Case

ENGINES = ("liggghts",)  # those that gather what the stiff regime needs (ParticleEngine::extras)
MILD_ONLY = ("virtual_mass", "lift")
RESPONSE = "response of the drag in a window, K W/m"


def choose(case: Case, ready: preflight.Prepared) -> None:
    """Puts "mild" or "stiff" in the place of "auto". What is not known is taken for mild; a fluid that
    hardly feels its particles (a limit that is never bad) is mild too. So is a particle engine that knows
mild only, and a model that does: the check then refuses by number what is beyond it."""
    if case.get("coupling.regime") != "auto":
        return
    coupled = case.get("fluid.engine") == "openfoam" and case.get("dem.engine") in ENGINES
    coupled = coupled and case.get("coupling.scheme") != "concurrent"  # which knows mild only
    feels = case.get("coupling.reaction") == "two_way" and case.get("models.drag") != "none"
    able = case.get("models.formulation") == "A" and all(
        case.get(f"models.{name}", "none") == "none" for name in MILD_ONLY)
    rows = []
    if coupled and feels and able and case.get("models.pressure_gradient"):
        rows = preflight.tool_findings(scene_numbers.collect(case, ready)
                                       | {"regime": "mild", "scheme": "serial"})
    stiff = any(row.quantity == RESPONSE and (row.bad or (row.verdict == "warn" and row.value <= row.limit))
                for row in rows)
    case.put("coupling.regime", "stiff" if stiff else "mild")
    if stiff:
        progress.say("coupling.regime: stiff (K W/m is beyond the mild regime)")
