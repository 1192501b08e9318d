"""Files through which one value reaches both sides: fluid/parameters (OpenFOAM, `#include`) and
dem/parameters (LIGGGHTS, read before the script)."""

from __future__ import annotations

import math
from pathlib import Path

from launch.case import Case


def number_text(value: int | float) -> str:
    """Shortest text that reads back as the same number."""
    return repr(value) if isinstance(value, int) or value != int(value) or abs(value) > 1e15 else str(int(value))


def common_values(case: Case) -> dict[str, int | float | str]:
    """[parameters] and what both sides must agree on: end_time [s], window [s], output_interval [s]."""
    values = dict(case.parameters)
    values["end_time"] = case.get("case.end_time")
    values["window"] = case.get("coupling.window")
    if case.get("output.interval"):
        values["output_interval"] = case.get("output.interval")
    return values


def gravity_parts(case: Case) -> dict[str, float]:
    """Gravity for LIGGGHTS: magnitude and components [m/s2]."""
    x, y, z = (float(v) for v in case.get("physics.gravity"))
    return {"gravity": math.sqrt(x * x + y * y + z * z), "gravity_x": x, "gravity_y": y, "gravity_z": z}


def reserved_names(case: Case) -> set[str]:
    """Names that slidewave gives itself and [parameters] must not have."""
    return {"end_time", "window", "output_interval", *gravity_parts(case)}


def fluid_text(case: Case) -> str:
    """Content of fluid/parameters."""
    lines = ["// Written by slidewave from case.toml; used as $name."]
    for name, value in common_values(case).items():
        text = number_text(value) if isinstance(value, (int, float)) else value
        if isinstance(value, str) and not value.replace("_", "").isalnum():
            text = f'"{value}"'
        lines.append(f"{name} {text};")
    gravity = " ".join(number_text(float(v)) for v in case.get("physics.gravity"))
    lines.append(f"gravity ({gravity});")
    return "\n".join(lines) + "\n"


def dem_text(case: Case) -> str:
    """Content of dem/parameters: index variables, which a script's own default does not override."""
    lines = ["# Written by slidewave from case.toml; used as ${name}."]
    for name, value in (common_values(case) | gravity_parts(case)).items():
        text = number_text(value) if isinstance(value, (int, float)) else value
        lines.append(f'variable {name} index "{text}"' if " " in text else f"variable {name} index {text}")
    return "\n".join(lines) + "\n"


def write(case: Case, fluid: Path | None, dem: Path | None) -> None:
    """Writes both files; a side that the scene does not have is None."""
    if fluid is not None:
        (fluid / "parameters").write_text(fluid_text(case))
    if dem is not None:
        (dem / "parameters").write_text(dem_text(case))
