"""Points of a study: the grid of --vary, the rows of --list, and the settings that each stands for.

A value is kept as the text that the user wrote, and goes to the run as --set key=text does.
"""

from __future__ import annotations

import csv
import itertools
import re
from dataclasses import dataclass
from pathlib import Path

from launch.errors import InputError

BRACKETS = {"[": 1, "{": 1, "]": -1, "}": -1}


@dataclass(frozen=True)
class Point:
    """One point: its settings (dotted key, text of the value) in the order of the command line."""

    settings: tuple[tuple[str, str], ...]
    title: str = ""

    @property
    def label(self) -> str:
        """The settings with the last word of each key, for people."""
        return self.title or ", ".join(f"{k.split('.')[-1]}={v}" for k, v in self.settings) or "as it is"

    def text(self, key: str) -> str:
        """Text of one setting, "" where the point leaves the case's value."""
        return dict(self.settings).get(key, "")

    def number(self, key: str) -> float | None:
        """One setting as a number, None where it is none."""
        try:
            return float(self.text(key))
        except ValueError:
            return None

    @property
    def words(self) -> list[str]:
        """The settings as key=value, as --set wants them."""
        return [f"{key}={value}" for key, value in self.settings]


def split_values(text: str) -> list[str]:
    """Splits at commas outside brackets and quotes: "[0,0,-1],[0,0,-2]" holds two values."""
    parts, depth, quote = [""], 0, ""
    for letter in text:
        if quote:
            quote = "" if letter == quote else quote
        elif letter in "\"'":
            quote = letter
        depth += 0 if quote else BRACKETS.get(letter, 0)
        if letter == "," and not quote and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [p.strip() for p in parts]


def parse_vary(text: str) -> tuple[str, list[str]]:
    """key=v1,v2,... of --vary. InputError where it is not that."""
    key, separator, rest = text.partition("=")
    key, values = key.strip(), split_values(rest)
    if not separator or not key or not all(values):
        raise InputError("--vary", text, None, "write key=v1,v2,..., e.g. coupling.window=1e-3,5e-4")
    if len(set(values)) < len(values):
        raise InputError("--vary", key, rest, "lists a value twice; --repeat N runs every point N times")
    return key, values


def read_list(path: Path) -> list[tuple[tuple[str, str], ...]]:
    """Points of --list: CSV, keys in the header, a point a row; an empty cell leaves the case's value."""
    try:
        with path.open(newline="", encoding="utf-8") as stream:
            rows = [[c.strip() for c in r] for r in csv.reader(stream) if r and not r[0].startswith("#")]
    except (OSError, UnicodeDecodeError) as error:
        raise InputError("--list", path.name, None, f"cannot be read: {error}") from error
    if len(rows) < 2:
        raise InputError(path, "--list", None, "holds no points: write keys in the first line, then a "
                                               "row of values for each point")
    for number, row in enumerate(rows[1:], start=2):
        if len(row) != len(rows[0]):
            raise InputError(path, f"row {number}", ",".join(row), f"has {len(row)} values for "
                             f"{len(rows[0])} keys; quote a value that holds a comma")
    return [tuple((k, v) for k, v in zip(rows[0], row) if v) for row in rows[1:]]


def expand(varied: list[tuple[str, list[str]]], listed: list[tuple[tuple[str, str], ...]]) -> list[Point]:
    """All combinations: rows of the list outermost, the key named last runs fastest. So the last
    point has the last-listed value of every key."""
    keys = [key for key, _ in varied] + list(dict.fromkeys(k for row in listed for k, _ in row))
    for key in keys:
        if keys.count(key) > 1:
            raise InputError("--vary", key, None, "is varied twice; give all values once")
    axes = [[(key, value) for value in values] for key, values in varied]
    return [Point(row + tuple(combination))
            for row in (listed or [()]) for combination in itertools.product(*axes)]


def keys_of(points: list[Point]) -> list[str]:
    """Every key that any point sets, in order of appearance."""
    return list(dict.fromkeys(key for point in points for key, _ in point.settings))


def file_name(point: Point, fingerprint: str, repeat: int) -> str:
    """Directory name of a point: its settings for people, the fingerprint for the computer."""
    words = re.sub(r"[^A-Za-z0-9.+_-]+", "_", point.label.replace(", ", "-").replace("=", "_"))
    return f"{words[:60].strip('_')}-{fingerprint}" + (f"-r{repeat}" if repeat > 1 else "")
