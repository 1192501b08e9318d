"""Section pictures over time: rock coloured by its initial layer, water by its fraction."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection, LineCollection, PolyCollection
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure

from launch import foam_file, foam_mesh, section_data, vtk_file

WATER = LinearSegmentedColormap.from_list("water", ["#f7f9fb", "#8fc1e3", "#1f5f99"])
FRAMES = 8


def figure(directory: Path, case: dict) -> tuple[Figure | None, str]:
    """One figure with up to FRAMES sections, and a sentence on what it shows; None without data."""
    meshes = _meshes(directory)
    series = vtk_file.read_series(directory / "dem" / "particles.vtk.series")
    box = _box(meshes, series)
    if box is None:
        return None, "No fields and no particles were written."
    plane = section_data.choose_plane(case.get("physics", {}).get("gravity", [0, 0, -1]), box)
    at = float(box[:, plane.normal].mean())
    frames, kind = section_data.frames(directory, plane, meshes, at, FRAMES)
    if not frames:
        return None, "No fields and no particles were written."
    limit = 1.0
    if kind == "U":
        limit = max((float(v.max()) for f in frames for v in f.values if v.size), default=0.0) or 1.0
    layers = _layers(frames, plane)
    drawing = _grid(frames, box, plane)
    for axes, frame in zip(drawing.axes, frames):
        _draw(axes, frame, box, plane, kind, limit, layers)
    return drawing, _caption(kind, limit, any(f.particles is not None for f in frames))


def _meshes(directory: Path) -> list[foam_mesh.Mesh]:
    try:
        return [foam_mesh.read_mesh(part) for part in foam_mesh.parts(directory / "fluid")]
    except foam_file.FoamFormatError:
        return []


def _box(meshes: list[foam_mesh.Mesh], series: list[tuple[float, Path]]) -> np.ndarray | None:
    clouds = [m.points for m in meshes]
    if not clouds:
        clouds = [_spheres(vtk_file.read_points(series[k][1])) for k in {0, len(series) - 1} if series]
    clouds = [c for c in clouds if len(c)]
    if not clouds:
        return None
    box = np.array([np.min([c.min(axis=0) for c in clouds], axis=0),
                    np.max([c.max(axis=0) for c in clouds], axis=0)])
    margin = 0.0 if meshes else 0.05 * np.ptp(box, axis=0).max()
    return box + np.array([[-1.0], [1.0]]) * max(margin, 0.0)


def _spheres(points: vtk_file.Points) -> np.ndarray:
    """Lowest and highest corners of the particles, so that one alone has a size too."""
    radius = np.reshape(points.data.get("radius", np.full(len(points.positions), 1e-3)), (-1, 1))
    return np.concatenate([points.positions - radius, points.positions + radius])


def _layers(frames: list[section_data.Frame], plane: section_data.Plane) -> dict[int, int]:
    """Layer of each particle by id: the engine's own, else ten bands of the first height."""
    first = next((f.particles for f in frames if f.particles is not None and len(f.particles.positions)),
                 None)
    if first is None:
        return {}
    ids = first.data.get("id", np.arange(len(first.positions)))
    layer = first.data.get("layer")
    if layer is None:
        height = first.positions[:, plane.up]
        layer = np.floor(9.999 * (height - height.min()) / max(np.ptp(height), 1e-300))
    return dict(zip(ids.astype(int).tolist(), layer.astype(int).tolist()))


def _grid(frames: list[section_data.Frame], box: np.ndarray, plane: section_data.Plane) -> Figure:
    size = box[1] - box[0]
    aspect = float(size[plane.up] / size[plane.along])
    most = min(2 if aspect < 1.0 else 4 if aspect < 2.5 else FRAMES, len(frames))
    rows = -(-len(frames) // most)
    columns = -(-len(frames) // rows)
    width = 11.0
    drawing = Figure(figsize=(width, min(rows * (width / columns * aspect + 0.45), 18.0)),
                     layout="constrained")
    for number in range(len(frames)):
        drawing.add_subplot(rows, columns, number + 1)
    return drawing


def _draw(axes: Axes, frame: section_data.Frame, box: np.ndarray, plane: section_data.Plane,
          kind: str | None, limit: float, layers: dict[int, int]) -> None:
    for polygons, values in zip(frame.polygons, frame.values):
        shade = PolyCollection(polygons, array=np.clip(values, 0, limit), cmap=WATER, linewidths=0.2,
                               edgecolors="face")
        shade.set_clim(0, limit)
        axes.add_collection(shade)
    for lines in frame.walls:
        axes.add_collection(LineCollection(lines, colors="#5b4a3a", linewidths=1.2))
    if frame.particles is not None and len(frame.particles.positions):
        _draw_particles(axes, frame.particles, plane, layers)
    axes.set_xlim(*box[:, plane.along])
    axes.set_ylim(*box[:, plane.up])
    axes.set_aspect("equal")
    axes.set_title(f"t = {frame.time_s:.4g} s", fontsize=9)
    axes.tick_params(labelsize=7)
    axes.set_xlabel(f"{'xyz'[plane.along]} [m]", fontsize=8)
    axes.set_ylabel(f"{'xyz'[plane.up]} [m]", fontsize=8)


def _draw_particles(axes: Axes, points: vtk_file.Points, plane: section_data.Plane,
                    layers: dict[int, int]) -> None:
    count = len(points.positions)
    ids = points.data.get("id", np.arange(count)).astype(int).tolist()
    layer = np.array([layers.get(i, 0) for i in ids])
    diameter = 2 * points.data.get("radius", np.zeros(count))
    order = np.argsort(points.positions[:, plane.normal])
    centres = points.positions[order][:, [plane.along, plane.up]]
    if not diameter.any():
        axes.scatter(*centres.T, s=4, c=layer[order], cmap="YlOrBr_r")
        return
    rock = EllipseCollection(diameter[order], diameter[order], np.zeros(count), units="xy",
                             offsets=centres, transOffset=axes.transData, array=layer[order],
                             cmap="YlOrBr_r", linewidths=0)
    rock.set_clim(min(layers.values(), default=0) - 1, max(layers.values(), default=1) + 3)
    axes.add_collection(rock)


def _caption(kind: str | None, limit: float, particles: bool) -> str:
    fluid = {None: "", "U": f"Fluid: speed, from 0 (white) to {limit:.3g} m/s (blue). "}.get(
        kind, "Fluid: water share of the cell (void fraction times saturation), from air (white) to 1 (blue). ")
    return fluid + ("Particles: true size, coloured by the layer they started in." if particles else "")
