"""Reads single values of an OpenFOAM dictionary that uses $name and #eval{}: enough for pre-flight."""

from __future__ import annotations

import re
from pathlib import Path

from launch.dem_script import evaluate
from launch.inputs import fluid_code


def expanded(path: Path, values: dict[str, object]) -> str:
    """Text of a dictionary without comments, $name and #eval{} replaced; "" where there is none."""
    if not path.is_file():
        return ""
    text = re.sub(r"\$\{?(\w+)\}?", lambda m: str(values.get(m.group(1), m.group())),
                  fluid_code(path.read_text()))

    def value(match: re.Match[str]) -> str:
        try:
            return repr(evaluate(match.group(1).strip().strip('"'), {}))
        except ValueError:
            return match.group()

    return re.sub(r"#eval\s*\{([^}]*)\}", value, text)


def entry(text: str, name: str) -> str | None:
    """The value of the first `name value;` outside of blocks, dimensions left out; None without one."""
    outside = text
    while (less := re.sub(r"\w+\s*\{[^{}]*\}", "", outside)) != outside:
        outside = less
    dimensions = rf"(?:{name}\s+)?(?:\[[^\]]*\]\s*)?"
    found = re.search(rf"(?:^|[;}}])\s*{name}\s+{dimensions}([^;{{}}]+);", outside, flags=re.M)
    return found.group(1).strip() if found else None


def number(text: str, name: str) -> float | None:
    """The same as a number; None where it is none."""
    try:
        return float(entry(text, name) or "")
    except ValueError:
        return None


def block(text: str, name: str) -> str:
    """What stands in `name { ... }` (no braces inside), "" where there is none."""
    found = re.search(rf"^\s*{name}\s*\{{([^{{}}]*)\}}", text, flags=re.M)
    return found.group(1) if found else ""
