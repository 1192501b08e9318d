"""What is known of a prepared scene before it runs: mesh, particles, patches. SI units."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from launch import dem_script, foam_mesh
from launch.case import Case

COUPLED = ("cyclic", "cyclicAMI", "processor")
AXES = "xyz"


@dataclass
class MeshFacts:
    """cells; box (2, 3) [m]; cell size in the plane of the flow and smallest [m]; thickness of a
    mesh one cell deep per axis (None elsewhere); axes with cyclic patches, and with closed ones."""

    cells: int
    box: np.ndarray
    cell_size_m: float
    smallest_m: float
    slab_axis: int | None
    cyclic: tuple[bool, bool, bool]
    flat: tuple[bool, bool, bool]


@dataclass
class Facts:
    """Mesh (None without a fluid case) and particle side of a scene."""

    mesh: MeshFacts | None
    dem: dem_script.DemScene

    @property
    def particles(self) -> int | None:
        """Number of particles; None where it is not known before the run."""
        if self.dem.positions is not None:
            return len(self.dem.positions)
        return None if self.dem.creates else 0

    @property
    def largest_diameter_m(self) -> float | None:
        diameters = self.dem.diameters
        return float(diameters.max()) if diameters is not None and diameters.size else None


def mesh_facts(fluid: Path) -> MeshFacts | None:
    """Facts of constant/polyMesh; None where there is no mesh."""
    if not any((fluid / "constant/polyMesh" / n).exists() for n in ("points", "points.gz")):
        return None
    mesh = foam_mesh.read_mesh(fluid)
    volumes = mesh.volumes()
    low, high = mesh.cell_bounds()
    box = np.array([mesh.points.min(axis=0), mesh.points.max(axis=0)])
    deep = (high - low).min(axis=0) > 0.999 * (box[1] - box[0])
    slab = int(np.argmax(deep)) if deep.sum() == 1 else None
    if slab is None:
        size = float(np.median(np.cbrt(volumes)))
    else:
        size = float(np.median(np.sqrt(volumes / (box[1] - box[0])[slab])))
    area, _ = mesh.face_vectors()
    cyclic, flat = [False] * 3, [False] * 3
    for patch in mesh.patches:
        if patch.faces == 0:
            continue
        total = np.abs(area[patch.start : patch.start + patch.faces]).sum(axis=0)
        axis = int(np.argmax(total))
        cyclic[axis] |= patch.type in COUPLED
        flat[axis] |= patch.type in ("empty", "symmetry", "symmetryPlane", "wedge")
    smallest = float((high - low)[:, [k for k in range(3) if k != slab]].min())
    return MeshFacts(mesh.cells, box, size, smallest, slab, tuple(cyclic), tuple(flat))


def gather(case: Case, directory: Path) -> Facts:
    """Facts of a prepared run directory."""
    mesh = mesh_facts(directory / "fluid") if case.get("fluid.engine") == "openfoam" else None
    if case.get("dem.engine") == "none":
        return Facts(mesh, dem_script.DemScene())
    if case.get("dem.engine") == "esys":  # a Python program: nothing is known before it runs
        return Facts(mesh, dem_script.DemScene(creates=True, gravity=True))
    script = directory / case.get("dem.script")
    return Facts(mesh, dem_script.read(script, directory / "dem" / "parameters"))
