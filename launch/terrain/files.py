"""Writes a section as OpenFOAM and LIGGGHTS read it: polyMesh, initial fields, STL wall."""

import re
from pathlib import Path

import numpy as np

from .mesh import Mesh, fraction_below
from .profile import Section

_HEADER = """FoamFile
{{
    version     2.0;
    format      ascii;
    class       {kind};
    location    "{location}";
    object      {name};
}}

"""


def _write(path, kind, location, body):
    path.write_text(_HEADER.format(kind=kind, location=location, name=path.name) + body)


def _list(lines):
    lines = list(lines)
    return f"{len(lines)}\n(\n" + "\n".join(lines) + "\n)\n"


def write_poly_mesh(mesh: Mesh, directory: Path):
    """Writes constant/polyMesh; `directory` is the polyMesh folder."""
    directory.mkdir(parents=True, exist_ok=True)
    where = "constant/polyMesh"
    _write(directory / "points", "vectorField", where,
           _list(f"({x:.10g} {y:.10g} {z:.10g})" for x, y, z in mesh.points))
    _write(directory / "faces", "faceList", where,
           _list(f"{len(face)}({' '.join(map(str, face))})" for face in mesh.faces))
    _write(directory / "owner", "labelList", where, _list(map(str, mesh.owner)))
    _write(directory / "neighbour", "labelList", where, _list(map(str, mesh.neighbour)))
    start = len(mesh.neighbour)
    patches = []
    for name, kind, count in mesh.patches:
        patches.append(f"    {name}\n    {{\n        type {kind};\n        nFaces {count};\n"
                       f"        startFace {start};\n    }}")
        start += count
    _write(directory / "boundary", "polyBoundaryMesh", where,
           f"{len(patches)}\n(\n" + "\n".join(patches) + "\n)\n")


def lake_fraction(mesh: Mesh, lake_level: float):
    """Share of each cell below the lake level: the water, inside the slide's pores too."""
    return np.array([fraction_below(outline, lake_level) for outline in mesh.outline])


def set_internal_field(path: Path, values):
    """Replaces the `internalField uniform ...;` of an OpenFOAM scalar field by one value a cell."""
    text = path.read_text()
    body = "internalField   nonuniform List<scalar>\n" + _list(f"{v:.12g}" for v in values) + ";"
    text, found = re.subn(r"internalField\s+uniform\s+[^;]*;", lambda _: body, text, count=1)
    if not found:
        raise ValueError(f"{path}: no 'internalField uniform ...;' to be replaced")
    path.write_text(text)


def wall_polyline(section: Section, longest: float):
    """The wall's vertices, with further ones so that no piece is longer than `longest` [m]."""
    wall = section.wall
    x = [wall[:1, 0]]
    for (x0, z0), (x1, z1) in zip(wall[:-1], wall[1:]):
        parts = int(np.ceil(np.hypot(x1 - x0, z1 - z0) / longest))
        x.append(np.linspace(x0, x1, parts + 1)[1:])
    x = np.concatenate(x)
    return np.column_stack([x, section.height(x)])


def write_wall_stl(section: Section, path: Path, low_y: float, high_y: float, longest: float):
    """Writes the rock surface as an ASCII STL from y = low_y to high_y [m], normals upwards."""
    lines = ["solid terrain"]
    line = wall_polyline(section, longest)
    for (x0, z0), (x1, z1) in zip(line[:-1], line[1:]):
        normal = np.array([z0 - z1, 0.0, x1 - x0])
        normal /= np.linalg.norm(normal)
        a, b, c, d = (x0, low_y, z0), (x1, low_y, z1), (x1, high_y, z1), (x0, high_y, z0)
        for corners in ((a, b, c), (a, c, d)):
            lines.append(f"facet normal {normal[0]:.12g} {normal[1]:.12g} {normal[2]:.12g}")
            lines.append("outer loop")
            lines += [f"vertex {x:.12g} {y:.12g} {z:.12g}" for x, y, z in corners]
            lines += ["endloop", "endfacet"]
    lines.append("endsolid terrain")
    path.write_text("\n".join(lines) + "\n")
