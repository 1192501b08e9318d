"""Reads legacy VTK POLYDATA of particles (binary or ascii), and the series file that lists them."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

TYPES = {"float": ">f4", "double": ">f8", "int": ">i4", "unsigned_int": ">u4", "long": ">i8",
         "vtktypeint64": ">i8", "short": ">i2", "unsigned_char": "u1", "char": "i1"}


class VtkFormatError(Exception):
    """A file that is not legacy VTK POLYDATA."""


@dataclass
class Points:
    """positions (N, 3) [m] and one array a point quantity, (N,) or (N, components)."""

    positions: np.ndarray
    data: dict[str, np.ndarray] = field(default_factory=dict)


class _Reader:
    def __init__(self, raw: bytes, binary: bool) -> None:
        self.raw, self.binary, self.at = raw, binary, 0

    def line(self) -> list[str] | None:
        """The next line that is not empty, as words; None at the end."""
        while self.at < len(self.raw):
            end = self.raw.find(b"\n", self.at)
            end = len(self.raw) if end < 0 else end
            words = self.raw[self.at : end].decode("latin-1").split()
            self.at = end + 1
            if words:
                return words
        return None

    def array(self, count: int, kind: str) -> np.ndarray:
        """The next `count` numbers."""
        if self.binary:
            dtype = np.dtype(TYPES[kind.lower()])
            if self.at + count * dtype.itemsize > len(self.raw):
                raise VtkFormatError("the file ends within an array")
            values = np.frombuffer(self.raw, dtype, count, self.at)
            self.at += count * dtype.itemsize
            return values.astype(dtype.newbyteorder("="))
        words: list[str] = []
        while len(words) < count:
            more = self.line()
            if more is None:
                raise VtkFormatError("the file ends within an array")
            words += more
        return np.array(words, dtype=np.dtype(TYPES[kind.lower()]).newbyteorder("="))


def read_points(path: Path) -> Points:
    """Points and point data of a file. Cells (VERTICES, LINES, POLYGONS) are passed over."""
    raw = path.read_bytes()
    head = raw.split(b"\n", 4)
    if len(head) < 4 or not head[0].startswith(b"# vtk DataFile") or b"POLYDATA" not in head[3]:
        raise VtkFormatError(f"{path}: not legacy VTK POLYDATA")
    reader = _Reader(raw, head[2].strip().upper() == b"BINARY")
    reader.at = sum(len(line) + 1 for line in head[:4])
    points = Points(np.empty((0, 3)))
    while (words := reader.line()) is not None:
        match words[0].upper():
            case "POINTS":
                points.positions = reader.array(3 * int(words[1]), words[2]).astype(float).reshape(-1, 3)
            case "VERTICES" | "LINES" | "POLYGONS":
                reader.array(int(words[2]), "int")
            case "SCALARS":
                width = int(words[3]) if len(words) > 3 else 1
                reader.line()  # LOOKUP_TABLE
                points.data[words[1]] = _shaped(reader, len(points.positions), width, words[2])
            case "VECTORS":
                points.data[words[1]] = _shaped(reader, len(points.positions), 3, words[2])
            case "FIELD":
                for _ in range(int(words[2])):
                    name, width, count, kind = reader.line() or ["", "0", "0", "float"]
                    points.data[name] = _shaped(reader, int(count), int(width), kind)
    return points


def _shaped(reader: _Reader, count: int, width: int, kind: str) -> np.ndarray:
    values = reader.array(count * width, kind)
    return values.reshape(count, width) if width > 1 else values


def read_series(path: Path) -> list[tuple[float, Path]]:
    """Times [s] and files of a ParaView .series file, ascending; files that are missing left out."""
    if not path.is_file():
        return []
    entries = json.loads(path.read_text()).get("files", [])
    found = [(float(e["time"]), path.parent / e["name"]) for e in entries]
    return sorted((t, p) for t, p in found if p.is_file())
