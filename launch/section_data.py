"""What a section picture shows: polygons of the mesh in the picture's plane, a field on them, and
particles, at a time. Works for any case: no fluid, one or two fluids, no particles."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from launch import foam_file, foam_mesh, vtk_file


@dataclass
class Plane:
    """Axes of the picture: along the page, up the page, into the page (0, 1, 2 for x, y, z)."""

    along: int
    up: int
    normal: int


def choose_plane(gravity: list[float], box: np.ndarray) -> Plane:
    """Up against gravity, along the longest other axis of `box` (2, 3) [m]; equal ones: the first."""
    up = int(np.argmax(np.abs(gravity))) if any(gravity) else 2
    size = box[1] - box[0]
    others = [k for k in range(3) if k != up]
    along = others[0] if size[others[0]] >= 0.999 * size[others[1]] else others[1]
    return Plane(along, up, 3 - up - along)


@dataclass
class Slice:
    """Cells cut by the picture's plane: which cells, and the outline of each, (cells, corners, 2) [m];
    outlines with fewer corners repeat their last one."""

    cells: np.ndarray
    polygons: np.ndarray


def slice_mesh(mesh: foam_mesh.Mesh, plane: Plane, at_m: float) -> Slice:
    """The face of each cut cell that looks most against the plane's normal stands for the cell."""
    low, high = mesh.cell_bounds()
    cut = (low[:, plane.normal] <= at_m) & (high[:, plane.normal] > at_m)
    area, _ = mesh.face_vectors()
    facing = area[:, plane.normal] / np.maximum(np.linalg.norm(area, axis=1), 1e-300)
    inner = mesh.neighbour.size
    cell = np.concatenate([mesh.owner, mesh.neighbour])
    face = np.concatenate([np.arange(mesh.owner.size), np.arange(inner)])
    outward = np.concatenate([facing, -facing[:inner]])
    order = np.lexsort((outward, cell))
    first = np.unique(cell[order], return_index=True)
    chosen = np.full(mesh.cells, -1)
    chosen[first[0]] = face[order[first[1]]]
    cells = np.flatnonzero(cut & (chosen >= 0))
    faces = chosen[cells]
    sizes = np.diff(mesh.offsets)[faces]
    corners = np.arange(sizes.max(initial=0))
    index = mesh.offsets[faces][:, None] + np.minimum(corners, sizes[:, None] - 1)
    points = mesh.points[mesh.labels[index]] if cells.size else np.empty((0, 0, 3))
    return Slice(cells, points[..., [plane.along, plane.up]])


def wall_lines(mesh: foam_mesh.Mesh, plane: Plane, cells: np.ndarray) -> np.ndarray:
    """Where walls cut the picture's plane, (lines, 2 ends, 2) [m]: wall faces of `cells`, seen edge on."""
    within = np.zeros(mesh.cells, bool)
    within[cells] = True
    walls = [np.arange(p.start, p.start + p.faces) for p in mesh.patches if p.type == "wall"]
    faces = np.concatenate(walls) if walls else np.empty(0, int)
    faces = faces[within[mesh.owner[faces]]] if faces.size else faces
    if not faces.size:
        return np.empty((0, 2, 2))
    corners = mesh.labels[np.minimum(mesh.offsets[faces][:, None] + np.arange(4),
                                     mesh.offsets[faces + 1][:, None] - 1)]
    points = mesh.points[corners][..., [plane.along, plane.up]]
    place = points @ np.array([1.0, 0.618])  # orders the corners along any edge-on face
    rows = np.arange(faces.size)
    return np.stack([points[rows, place.argmin(axis=1)], points[rows, place.argmax(axis=1)]], axis=1)


@dataclass
class Frame:
    """One picture: time [s]; water fraction of the cell or speed [m/s] on the polygons; walls as
    lines; particles."""

    time_s: float
    polygons: list[np.ndarray] = field(default_factory=list)
    values: list[np.ndarray] = field(default_factory=list)
    walls: list[np.ndarray] = field(default_factory=list)
    particles: vtk_file.Points | None = None


def field_kind(fluid: Path, time: str) -> str | None:
    """Name of the phase field alpha.*, else "U" for one fluid; None without any."""
    place = foam_mesh.parts(fluid)[0] / time
    phases = sorted(p.name.removesuffix(".gz") for p in place.glob("alpha.*"))
    if phases:
        return phases[0]
    return "U" if any((place / n).is_file() for n in ("U", "U.gz")) else None


def cell_values(part: Path, time: str, kind: str, cells: int) -> np.ndarray:
    """eps * alpha of the cells with two fluids, |U| [m/s] with one."""
    if kind == "U":
        return np.linalg.norm(foam_file.read_field(part / time / "U", cells), axis=1)
    values = foam_file.read_field(part / time / kind, cells)
    if any((part / time / n).is_file() for n in ("eps", "eps.gz")):
        values = values * foam_file.read_field(part / time / "eps", cells)
    return values


def nearest(times: list[float], wanted: float) -> int:
    """Index of the entry closest to `wanted`."""
    return int(np.argmin(np.abs(np.array(times) - wanted)))


def spread(times: list[float], count: int) -> list[float]:
    """At most `count` of `times`, evenly spread, first and last among them."""
    if len(times) <= count:
        return times
    wanted = np.linspace(times[0], times[-1], count)
    return [times[k] for k in sorted({nearest(times, w) for w in wanted})]


def frames(directory: Path, plane: Plane, meshes: list[foam_mesh.Mesh], at_m: float,
           count: int) -> tuple[list[Frame], str | None]:
    """Pictures over time, and what the fluid's values are ("alpha.x", "U" or None)."""
    fluid = directory / "fluid"
    named = foam_mesh.times(fluid) if meshes else []
    series = vtk_file.read_series(directory / "dem" / "particles.vtk.series")
    both = [t for t, _ in named if not series or _close([s for s, _ in series], t)]
    shown = spread(both or [t for t, _ in named or series], count)
    kind = field_kind(fluid, named[-1][1]) if named else None
    slices = [slice_mesh(mesh, plane, at_m) for mesh in meshes]
    walls = [wall_lines(mesh, plane, cut.cells) for mesh, cut in zip(meshes, slices)]
    result = []
    for time in shown:
        frame = Frame(time, walls=walls)
        if kind:
            name = named[nearest([t for t, _ in named], time)][1]
            for part, mesh, cut in zip(foam_mesh.parts(fluid), meshes, slices):
                if cut.cells.size:
                    frame.polygons.append(cut.polygons)
                    frame.values.append(cell_values(part, name, kind, mesh.cells)[cut.cells])
        if series:
            frame.particles = vtk_file.read_points(series[nearest([t for t, _ in series], time)][1])
        result.append(frame)
    return result, kind


def _close(times: list[float], wanted: float) -> bool:
    return bool(np.min(np.abs(np.array(times) - wanted)) < 1e-6 * max(1.0, abs(wanted)))
