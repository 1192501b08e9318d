"""Every key that case.toml may have: type, unit, range, meaning. SI, no unit suffix in keys.

`python3 -m launch.schema` prints the table for docs/case_format.md.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

from launch.errors import did_you_mean


@dataclass(frozen=True)
class Key:
    """One key: kind is number, whole, text, flag, vector (3 numbers), numbers (a list) or scalar (number or
    text)."""

    kind: str
    meaning: str
    unit: str = ""
    above: float | None = None
    least: float | None = None
    choices: tuple[str, ...] = ()
    required: bool = False


KEYS: dict[str, Key] = {
    "case.name": Key("text", "name of the case, also of its run directory", required=True),
    "case.title": Key("text", "one line for the report"),
    "case.end_time": Key("number", "physical time to cover", "s", above=0, required=True),
    "case.default_variant": Key("text", "variant that runs without --variant"),
    "coupling.window": Key("number", "time between two exchanges", "s", above=0, required=True),
    "coupling.scheme": Key("text", "serial: fluid first, then particles with its result; concurrent: both at once, each "
                           "with the other's last state (short windows only: docs/stability.md); auto: concurrent where "
                           "the pre-flight check proves it and each rank has a core",
                           choices=("serial", "concurrent", "auto")),
    "coupling.regime": Key("text", "mild: short windows, cheapest; stiff: drag right for any K W/m (docs/stability.md); "
                           "auto, the default: what the pre-flight check finds needed", choices=("auto", "mild", "stiff")),
    "coupling.patience": Key("number", "longest wait for the other side", "s", above=0),
    "coupling.reaction": Key("text", "two_way: the particles act on the fluid; one_way: they do not",
                             choices=("two_way", "one_way")),
    "coupling.outside": Key("text", "what to do about a particle outside the mesh",
                            choices=("error", "warn", "ignore")),
    "coupling.smoothing_length": Key("number", "length of the void-fraction kernel; default "
                                     "max(1.5 D_max, 1.5 cell size)", "m", above=0),
    "coupling.deposit": Key("text", "how a particle's volume reaches the cells before smoothing: spline, "
                            "over the cells around, without jumps; centroid, to its cell (cheaper); "
                            "default spline where D_max exceeds a quarter of the cell",
                            choices=("spline", "centroid")),
    "models.drag": Key("text", "drag law; the first two and single_sphere take a coefficient of one sphere",
                       choices=("di_felice", "rong", "ergun", "wen_yu", "gidaspow", "koch_hill", "beetstra",
                                "single_sphere", "none")),
    "models.drag_coefficient": Key("text", "drag coefficient of one sphere",
                                   choices=("brown_lawler", "dalla_valle", "schiller_naumann", "stokes")),
    "models.formulation": Key("text", "A: particles share the pressure gradient; B: the fluid carries it whole, "
                              "drag K/eps and Archimedes' force act on particles (two-way: mild regime, serial scheme)", choices=("A", "B")),
    "models.pressure_gradient": Key("flag", "pressure-gradient force (buoyancy) on the particles; default true in formulation A, "
                                    "not in B"),
    "models.viscous_force": Key("flag", "particles carry their share V div(tau) of the viscous stress (A only); default false"),
    "models.virtual_mass": Key("text", "fluid that particles move along, C rho V: none (default); constant, C = 1/2; "
                               "zuber, C = (1 + 2 phi)/(2 (1 - phi))", choices=("none", "constant", "zuber")),
    "models.lift": Key("text", "lift of particles that lag in a shear; default none", choices=("none", "saffman_mei")),
    "models.torque": Key("text", "fluid turns particles: pi mu d^3 (curl u/2 - w); default none",
                         choices=("none", "rotational_drag")),
    "models.contact_scaling": Key("text", "how contact constants follow coarse_grain; none: as given; "
                                  "proportional: K ~ D; sakai: forces of all grains (docs/contact.md)",
                                  choices=("none", "proportional", "sakai")),
    "models.coarse_grain_by_type": Key("numbers", "D/d of each particle type, instead of parameters.coarse_grain", "-",
                                       least=1),
    "physics.gravity": Key("vector", "acceleration of gravity", "m/s2", required=True),
    "fluid.engine": Key("text", "fluid side; none: a dry scene, no fluid program is started; "
                        "uniform_flow: prescribed by [uniform_flow], one-way only",
                        choices=("openfoam", "none", "uniform_flow")),
    "uniform_flow.density": Key("number", "density of the prescribed fluid", "kg/m3", above=0),
    "uniform_flow.viscosity": Key("number", "its dynamic viscosity", "Pa s", above=0),
    "uniform_flow.velocity": Key("vector", "its velocity U at the origin; default 0", "m/s"),
    "uniform_flow.amplitude": Key("vector", "A of an oscillation A sin(2 pi t/T); default 0", "m/s"),
    "uniform_flow.period": Key("number", "its period T", "s", above=0),
    "uniform_flow.gradient_u": Key("vector", "gradient of the x velocity; default 0", "1/s"),
    "uniform_flow.gradient_v": Key("vector", "gradient of the y velocity; default 0", "1/s"),
    "uniform_flow.gradient_w": Key("vector", "gradient of the z velocity; default 0", "1/s"),
    "dem.engine": Key("text", "particle side; none: fluid alone, no particle program is started; "
                      "lammps, esys (ESyS-Particle): optional", choices=("liggghts", "none", "lammps", "esys")),
    "dem.energy_audit": Key("flag", "energy columns of runs with model linear; default true"),
    "dem.overlap_limit": Key("number", "largest overlap of two particles over the smaller diameter, above which "
                             "the run ends; default 0.3", above=0),
    "dem.script": Key("text", "script that sets the particles up, in the language of dem.engine"),
    "check.speed": Key("number", "fastest particle or fluid expected, for the pre-flight check", "m/s",
                       above=0),
    "check.held": Key("flag", "no particle is free to move (frozen, or jammed between frozen ones): the pre-flight "
                      "check leaves out what only free ones do; default false"),
    "checkpoint.windows": Key("whole", "windows between two checkpoints", least=1),
    "checkpoint.interval": Key("number", "wall time between two checkpoints, taken at a window's end", "s",
                               above=0),
    "checkpoint.at_end": Key("flag", "a checkpoint at the end of the run too"),
    "checkpoint.keep": Key("whole", "how many checkpoints are kept, the newest; default 2", least=1),
    "output.interval": Key("number", "time between two pictures (fields, particles)", "s", above=0),
    "output.layers": Key("whole", "layers of initial height that particles are coloured by", least=0),
    "output.headline": Key("text", "column of history.csv shown while running"),
    "parameters.*": Key("scalar", "a value that the fluid case or the script uses by name"),
    "parameters.coarse_grain": Key("number", "particle diameter over grain diameter, D/d", "-", least=1),
    "parameters.dem_dt": Key("number", "particle step wanted; the window holds a whole number",
                             "s", above=0),
    "observe.*.type": Key("text", "which observer of an engine", required=True,
                          choices=("wave", "gauge", "slide", "particle")),
    "observe.*.*": Key("number", "setting of the observer (table below)"),
    "geometry.**": Key("any", "profiles and sizes from which meshes are made"),
    "target.name": Key("text", "what is compared", required=True),
    "target.column": Key("text", "column of history.csv", required=True),
    "target.reduce": Key("text", "which value of the column",
                         choices=("max", "min", "final", "time_of_max", "mean")),
    "target.until": Key("number", "only rows of history.csv up to this time count", "s", above=0),
    "target.reference": Key("number", "published or analytic value", required=True),
    "target.tolerance": Key("number", "largest relative error that passes", "-", above=0),
    "target.tolerance_absolute": Key("number", "largest error that passes, in the column's unit",
                                     above=0),
    "target.required": Key("flag", "a miss makes the run's exit status 1"),
    "target.one_way": Key("number", "value of the run without reaction, for comparison"),
    "target.no_water": Key("number", "value of the dry run, for comparison"),
    "target.source": Key("text", "where the reference comes from", required=True),
}

# Settings of each type of observer: those it needs, those it may have.
OBSERVERS: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "wave": (("level", "bank_x"), ()),
    "gauge": (("x",), ("y",)),
    "slide": ((), ()),
    "particle": (("id",), ()),
}


def find_key(dotted: str) -> Key | None:
    """The entry for a dotted key: exact, or a pattern with * for one name and ** for any below."""
    if dotted in KEYS:
        return KEYS[dotted]
    words = dotted.split(".")
    for pattern, key in KEYS.items():
        parts = pattern.split(".")
        if parts[-1] == "**" and words[: len(parts) - 1] == parts[:-1] and len(words) >= len(parts):
            return key
        if len(parts) == len(words) and all(p in ("*", w) for p, w in zip(parts, words)):
            return key
    return None


def hint(dotted: str) -> str:
    """What a user may have meant by an unknown key."""
    tails = {k.split(".")[-1]: k for k in KEYS if "*" not in k}
    tail = dotted.split(".")[-1]
    begun = [k for k in tails.values() if k.startswith(dotted)]
    if tail in tails or begun:
        return f"did you mean {(tails.get(tail) or begun[0])!r}?"
    return did_you_mean(dotted, (k for k in KEYS if "*" not in k)) or "slidewave knows no such key"


def fault(key: Key, value: object) -> str | None:
    """Why a value does not fit its key, as a remedy; None where it fits."""
    unit = f" [{key.unit}]" if key.unit and key.unit != "-" else ""
    if key.kind in ("number", "whole"):
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            return f"give a number{unit}, without quotes"
        if key.kind == "whole" and not isinstance(value, int):
            return "give a whole number"
        if not math.isfinite(value):
            return f"give a finite number{unit}"
        if key.above is not None and value <= key.above:
            return f"give a number{unit} above {key.above:g}"
        if key.least is not None and value < key.least:
            return f"give a number{unit} of at least {key.least:g}"
    elif key.kind == "text":
        if not isinstance(value, str) or not value:
            return "give a text in quotes"
        if key.choices and value not in key.choices:
            guess = did_you_mean(value, key.choices)
            return f"give one of {', '.join(key.choices)}" + (f"; {guess}" if guess else "")
    elif key.kind == "flag":
        if not isinstance(value, bool):
            return "give true or false"
    elif key.kind == "vector":
        good = isinstance(value, list) and len(value) == 3 and all(
            isinstance(v, (int, float)) and not isinstance(v, bool) and math.isfinite(v)
            for v in value)
        if not good:
            return f"give three numbers{unit}, e.g. [0, 0, -9.81]"
    elif key.kind == "numbers":
        if not isinstance(value, list) or not value:
            return "give a list of numbers, e.g. [1, 2]"
        one = replace(key, kind="number")
        return next((f"{remedy}, in each place" for remedy in (fault(one, v) for v in value) if remedy), None)
    elif key.kind == "scalar":
        if isinstance(value, (bool, list, dict)):
            return "give a number or a text"
        if isinstance(value, float) and not math.isfinite(value):
            return "give a finite number"
    return None


def leaves(table: dict, prefix: str = "") -> Iterator[tuple[str, object]]:
    """Dotted key and value of everything that is not a table."""
    for name, value in table.items():
        dotted = f"{prefix}{name}"
        if isinstance(value, dict):
            yield from leaves(value, dotted + ".")
        else:
            yield dotted, value


if __name__ == "__main__":
    for name, entry in KEYS.items():
        extent = ", ".join(entry.choices) or (f"> {entry.above:g}" if entry.above is not None else
                                              f">= {entry.least:g}" if entry.least is not None else "")
        need = "required" if entry.required else ""
        print(f"| `{name}` | {entry.kind} | {entry.unit} | {extent} | {need} | {entry.meaning} |")
