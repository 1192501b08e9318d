"""Reads OpenFOAM files (ascii or binary, plain or gzip) into numpy arrays. 32-bit labels, doubles."""

from __future__ import annotations

import gzip
import re
from pathlib import Path

import numpy as np

COMPONENTS = {"scalar": 1, "vector": 3, "symmTensor": 6, "tensor": 9}


class FoamFormatError(Exception):
    """A file that is not what its place says."""


def read_bytes(path: Path) -> bytes:
    """Content of `path`, or of `path`.gz."""
    if path.is_file():
        return path.read_bytes()
    zipped = path.with_name(path.name + ".gz")
    if zipped.is_file():
        return gzip.decompress(zipped.read_bytes())
    raise FoamFormatError(f"{path}: no such file")


def is_binary(raw: bytes) -> bool:
    """Whether the FoamFile header says format binary."""
    header = raw[: raw.find(b"}") + 1]
    return re.search(rb"\bformat\s+binary\s*;", header) is not None


def body(raw: bytes) -> bytes:
    """Everything after the FoamFile header."""
    start = raw.find(b"FoamFile")
    return raw[raw.find(b"}", start) + 1 :] if start >= 0 else raw


def find_list(raw: bytes, start: int = 0) -> tuple[int, int]:
    """Length of the next list `N(` at or after `start`, and where its first element begins."""
    found = re.compile(rb"(?:^|\s)(\d+)\s*\(").search(raw, start)
    if not found:
        raise FoamFormatError("no list where one is expected")
    return int(found.group(1)), found.end()


def numbers(raw: bytes, dtype: type) -> np.ndarray:
    """All numbers of an ascii list, brackets ignored."""
    return np.array(raw.translate(bytes.maketrans(b"()", b"  ")).split(), dtype=dtype)


def read_list(raw: bytes, start: int, binary: bool, dtype: type, width: int = 1) -> tuple[np.ndarray, int]:
    """A list of `width` numbers each, (N, width) or (N,), and where it ends."""
    count, first = find_list(raw, start)
    if binary:
        size = count * width * np.dtype(dtype).itemsize
        values = np.frombuffer(raw, dtype, count * width, first) if count else np.empty(0, dtype)
        last = first + size
    else:
        last = _closing(raw, first)
        values = numbers(raw[first:last], dtype)
    if values.size != count * width:
        raise FoamFormatError(f"a list of {count} holds {values.size // width}")
    return (values.reshape(count, width) if width > 1 else values), last + 1


def _closing(raw: bytes, start: int) -> int:
    """Position of the bracket that closes a list whose content begins at `start`."""
    depth = 1
    for match in re.compile(rb"[()]").finditer(raw, start):
        depth += 1 if match.group() == b"(" else -1
        if depth == 0:
            return match.start()
    raise FoamFormatError("a list does not end")


def read_labels(path: Path) -> np.ndarray:
    """A labelList such as owner or neighbour, (N,)."""
    raw = read_bytes(path)
    return read_list(body(raw), 0, is_binary(raw), np.int32)[0]


def read_points(path: Path) -> np.ndarray:
    """A vectorField such as points [m], (N, 3)."""
    raw = read_bytes(path)
    return read_list(body(raw), 0, is_binary(raw), np.float64, 3)[0]


def read_faces(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Faces as offsets (N+1,) into point labels: face i has labels[offsets[i]:offsets[i+1]]."""
    raw = read_bytes(path)
    content = body(raw)
    if is_binary(raw):
        offsets, end = read_list(content, 0, True, np.int32)
        return offsets, read_list(content, end, True, np.int32)[0]
    count, first = find_list(content)
    flat = numbers(content[first : _closing(content, first)], np.int32)
    sizes = np.empty(count, np.int32)
    starts = np.empty(count, np.int64)
    position = 0
    for i in range(count):
        sizes[i] = flat[position]
        starts[i] = position
        position += sizes[i] + 1
    keep = np.ones(flat.size, bool)
    keep[starts] = False
    return np.concatenate(([0], np.cumsum(sizes))).astype(np.int32), flat[keep]


def read_field(path: Path, cells: int) -> np.ndarray:
    """internalField of a volume field: (cells,) for a scalar, (cells, components) otherwise."""
    raw = read_bytes(path)
    content = body(raw)
    place = content.find(b"internalField")
    if place < 0:
        raise FoamFormatError(f"{path}: no internalField")
    uniform = re.compile(rb"internalField\s+uniform\s+([^;]+);").match(content, place)
    if uniform:
        values = numbers(uniform.group(1), np.float64)
        return np.tile(values, (cells, 1)).reshape((cells,) if values.size == 1 else (cells, -1))
    kind = re.compile(rb"internalField\s+nonuniform\s+List<(\w+)>").match(content, place)
    if not kind:
        empty = re.compile(rb"internalField\s+nonuniform\s+0").match(content, place)
        if empty and cells == 0:
            return np.empty(0)
        raise FoamFormatError(f"{path}: internalField is neither uniform nor a list")
    width = COMPONENTS[kind.group(1).decode()]
    values = read_list(content, kind.end(), is_binary(raw), np.float64, width)[0]
    if len(values) != cells:
        raise FoamFormatError(f"{path}: {len(values)} values for {cells} cells")
    return values
