"""An OpenFOAM mesh and its time directories, serial or decomposed, as numpy arrays."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from launch import foam_file


@dataclass
class Patch:
    """A boundary patch: its name, type, number of faces and first face."""

    name: str
    type: str
    faces: int
    start: int


@dataclass
class Mesh:
    """One polyMesh. points (P, 3) [m]; face i has labels[offsets[i]:offsets[i+1]]; owner (F,),
    neighbour (internal faces,); patches."""

    points: np.ndarray
    offsets: np.ndarray
    labels: np.ndarray
    owner: np.ndarray
    neighbour: np.ndarray
    patches: list[Patch]

    @property
    def cells(self) -> int:
        return int(self.owner.max()) + 1 if self.owner.size else 0

    def face_vectors(self) -> tuple[np.ndarray, np.ndarray]:
        """Area vectors [m2] (out of the owner) and centres [m] of all faces, (F, 3) each."""
        sizes = np.diff(self.offsets)
        face = np.repeat(np.arange(sizes.size), sizes)
        point = self.points[self.labels]
        following = np.arange(self.labels.size) + 1
        following[self.offsets[1:] - 1] = self.offsets[:-1]
        centre = _sum(face, point, sizes.size) / sizes[:, None]
        triangle = 0.5 * np.cross(point - centre[face], point[following] - centre[face])
        area = _sum(face, triangle, sizes.size)
        weight = np.linalg.norm(triangle, axis=1)
        third = (point + point[following] + centre[face]) / 3
        total = np.maximum(np.bincount(face, weight, sizes.size), 1e-300)
        return area, _sum(face, third * weight[:, None], sizes.size) / total[:, None]

    def cell_bounds(self) -> tuple[np.ndarray, np.ndarray]:
        """Lowest and highest corner of each cell [m], (cells, 3) each."""
        low = np.minimum.reduceat(self.points[self.labels], self.offsets[:-1], axis=0)
        high = np.maximum.reduceat(self.points[self.labels], self.offsets[:-1], axis=0)
        lowest = np.full((self.cells, 3), np.inf)
        highest = np.full((self.cells, 3), -np.inf)
        inner = self.neighbour.size
        for cells, faces in ((self.owner, slice(None)), (self.neighbour, slice(0, inner))):
            np.minimum.at(lowest, cells, low[faces])
            np.maximum.at(highest, cells, high[faces])
        return lowest, highest

    def volumes(self) -> np.ndarray:
        """Volume of each cell [m3], (cells,), by the divergence theorem."""
        area, centre = self.face_vectors()
        flux = np.einsum("ij,ij->i", area, centre) / 3
        inner = self.neighbour.size
        return (np.bincount(self.owner, flux, self.cells)
                - np.bincount(self.neighbour, flux[:inner], self.cells))


def _sum(index: np.ndarray, values: np.ndarray, size: int) -> np.ndarray:
    return np.stack([np.bincount(index, values[:, k], size) for k in range(3)], axis=1)


def read_patches(path: Path) -> list[Patch]:
    """The patches of constant/polyMesh/boundary."""
    text = re.sub(r"//[^\n]*", "", foam_file.body(foam_file.read_bytes(path)).decode(errors="replace"))
    patches = []
    for name, entries in re.findall(r"(\S+)\s*\{([^{}]*)\}", text):
        kind = re.search(r"\btype\s+(\w+)\s*;", entries)
        faces = re.search(r"\bnFaces\s+(\d+)\s*;", entries)
        start = re.search(r"\bstartFace\s+(\d+)\s*;", entries)
        if kind and faces and start:
            patches.append(Patch(name, kind.group(1), int(faces.group(1)), int(start.group(1))))
    return patches


def read_mesh(case: Path) -> Mesh:
    """constant/polyMesh of an OpenFOAM case or of one of its processor directories."""
    place = case / "constant" / "polyMesh"
    return Mesh(foam_file.read_points(place / "points"), *foam_file.read_faces(place / "faces"),
                foam_file.read_labels(place / "owner"), foam_file.read_labels(place / "neighbour"),
                read_patches(place / "boundary"))


def parts(case: Path) -> list[Path]:
    """The processor directories of a decomposed case in order, else the case itself."""
    found = sorted(case.glob("processor[0-9]*"), key=lambda p: int(p.name[9:]))
    return found or [case]


def times(case: Path) -> list[tuple[float, str]]:
    """Time directories: value [s] and name, ascending."""
    found = []
    for path in parts(case)[0].iterdir():
        if path.is_dir() and re.fullmatch(r"\d+(\.\d*)?([eE][-+]?\d+)?", path.name):
            found.append((float(path.name), path.name))
    return sorted(found)
