"""Reads both sides' input files as text: which parameters they use, where they repeat one as a
literal, and where the two sides would disagree. Errors name file, key, value and remedy."""

from __future__ import annotations

import re
from pathlib import Path

from launch.case import Case
from launch.errors import InputError
from launch.parameters import common_values, gravity_parts, reserved_names

READ_BY_PROGRAMS = {"coarse_grain", "dem_dt"}
LARGEST_TEXT = 200_000
NUMBER = re.compile(r"(?<![\w.$\"/])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w.])")


def texts(directory: Path) -> dict[Path, str]:
    """Small text files below a directory, without meshes, geometry and particle data."""
    found = {}
    for path in sorted(directory.rglob("*")):
        if not path.is_file() or path.suffix in (".stl", ".data", ".gz") or "polyMesh" in path.parts:
            continue
        if path.stat().st_size <= LARGEST_TEXT:
            try:
                found[path] = path.read_text()
            except UnicodeDecodeError:
                continue
    return found


def fluid_code(text: str) -> str:
    """An OpenFOAM dictionary without comments, lines kept."""
    text = re.sub(r"/\*.*?\*/", lambda m: "\n" * m.group().count("\n"), text, flags=re.S)
    return re.sub(r"//[^\n]*", "", text)


def dem_code(text: str) -> str:
    """A LIGGGHTS script without comments, continued lines joined."""
    return re.sub(r"#[^\n]*", "", text.replace("&\n", " "))


def significant_digits(value: float) -> int:
    """Digits of a number without leading and trailing zeros: 2650 has 3, 1000 has 1."""
    return len(f"{abs(value):.12e}".split("e")[0].replace(".", "").rstrip("0"))


def line_of(text: str, position: int) -> int:
    return text.count("\n", 0, position) + 1


def check_inputs(case: Case, by_geometry: set[str] = frozenset()) -> None:
    """All checks of this module. `by_geometry`: parameters that the mesh-making code uses."""
    sides = {}
    if case.get("fluid.engine") == "openfoam":
        sides["fluid"] = {p: fluid_code(t) for p, t in texts(case.directory / "fluid").items()}
    if case.get("dem.engine") != "none":
        sides["dem"] = {p: dem_code(t) for p, t in texts(case.directory / "dem").items()}
    everything = "\n".join(t for side in ("fluid", "dem") for t in texts(case.directory / side).values())
    for name in case.parameters:
        if name in reserved_names(case):
            raise InputError(case.file, f"parameters.{name}", case.parameters[name],
                             "slidewave gives this name itself; choose another")
    _check_used(case, everything, by_geometry)
    for side, files in sides.items():
        for path, text in files.items():
            if path.suffix != ".py":  # a program may hold any number
                _check_repeated(case, side, path, text)
    _check_gravity(case, sides)
    _check_end_time(case, sides.get("fluid", {}))


def _check_used(case: Case, everything: str, by_geometry: set[str]) -> None:
    """`everything`: both sides' files, of a side too that this variant does not start."""
    for name, value in case.parameters.items():
        used = name in READ_BY_PROGRAMS | case.used | by_geometry
        if not used and not re.search(rf"\$\{{?{name}\b|\bv_{name}\b", everything):
            raise InputError(case.file, f"parameters.{name}", value,
                             f"no side uses it; remove it, or write ${name} where it belongs")


def _check_repeated(case: Case, side: str, path: Path, text: str) -> None:
    given = common_values(case) | gravity_parts(case)
    numbers = {n: float(v) for n, v in given.items() if isinstance(v, (int, float))}
    for name, value in given.items():
        shown = f"${name}" if side == "fluid" else f"${{{name}}}"
        entry = (rf"^\s*{name}\s+([^$#;\s][^;$#]*);" if side == "fluid"
                 else rf"^\s*variable\s+{name}\s+(?!index\b)(\w+.*)$")
        found = re.search(entry, text, flags=re.M)
        if found:
            raise InputError(f"{path}:{line_of(text, found.start(1))}", name, found.group(1).strip(),
                             f"the case gives {name} = {value}; write {shown}")
    code = re.sub(r"^\s*variable\s+\w+\s+index\b[^\n]*", "", text, flags=re.M) if side == "dem" else text
    for match in NUMBER.finditer(code):
        literal = float(match.group())
        if significant_digits(literal) < 3:
            continue
        for name, value in numbers.items():
            if abs(abs(literal) - abs(value)) <= 1e-12 * abs(value):
                shown = f"${name}" if side == "fluid" else f"${{{name}}}"
                raise InputError(f"{path}:{line_of(code, match.start())}", name, match.group(),
                                 f"repeats a value of case.toml; write {shown}")


def _check_gravity(case: Case, sides: dict[str, dict[Path, str]]) -> None:
    wanted = [float(v) for v in case.get("physics.gravity")]
    for path, text in sides.get("fluid", {}).items():
        found = re.search(r"^\s*value\s+\(([^)$]*)\)", text, flags=re.M) if path.name == "g" else None
        if found and [float(v) for v in found.group(1).split()] != wanted:
            raise InputError(path, "gravity", found.group(1),
                             f"the sides disagree: physics.gravity is {wanted}; write $gravity")
    for path, text in sides.get("dem", {}).items():
        found = re.search(r"^\s*fix\s+\S+\s+\S+\s+gravity\s+([\d.eE+-]+)", text, flags=re.M)
        magnitude = gravity_parts(case)["gravity"]
        if found and abs(float(found.group(1)) - magnitude) > 1e-9 * max(1.0, magnitude):
            raise InputError(path, "gravity", found.group(1),
                             f"the sides disagree: physics.gravity has {magnitude:g} m/s2; write ${{gravity}}")


def _check_end_time(case: Case, fluid: dict[Path, str]) -> None:
    wanted = float(case.get("case.end_time"))
    for path, text in fluid.items():
        if path.name != "controlDict":
            continue
        found = re.search(r"^\s*endTime\s+([\d.eE+-]+)\s*;", text, flags=re.M)
        if found and abs(float(found.group(1)) - wanted) > 1e-9 * wanted:
            raise InputError(path, "endTime", found.group(1),
                             f"the sides disagree: case.end_time is {wanted:g} s; write $end_time")
