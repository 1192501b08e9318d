"""Writes a tiny OpenFOAM mesh (two unit cubes side by side in x) and fields, ascii or binary."""

from __future__ import annotations

import struct
from pathlib import Path

POINTS = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1, 2)]
FACES = [(1, 4, 10, 7),  # between the cells, out of cell 0
         (0, 6, 9, 3), (2, 5, 11, 8),  # ends
         (0, 1, 7, 6), (1, 2, 8, 7), (3, 9, 10, 4), (4, 10, 11, 5),  # front y = 0, back y = 1
         (0, 3, 4, 1), (1, 4, 5, 2), (6, 7, 10, 9), (7, 8, 11, 10)]  # bottom, top
OWNER = [0, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1]
NEIGHBOUR = [1]
BOUNDARY = """3
(
    ends { type wall; nFaces 2; startFace 1; }
    sides { type empty; inGroups 1(empty); nFaces 4; startFace 3; }
    rest { type patch; nFaces 4; startFace 7; }
)
"""


def head(kind: str, binary: bool) -> bytes:
    style = "binary" if binary else "ascii"
    return (f"FoamFile\n{{\n version 2.0; format {style}; class {kind};\n}}\n// *** //\n").encode()


def ints(values: list[int], binary: bool) -> bytes:
    raw = struct.pack(f"<{len(values)}i", *values) if binary else "\n".join(map(str, values)).encode()
    return f"\n{len(values)}\n(".encode() + raw + b")\n"


def vectors(values: list[tuple], binary: bool) -> bytes:
    if binary:
        raw = b"".join(struct.pack(f"<{len(v)}d", *v) for v in values)
    else:
        raw = "\n".join("(" + " ".join(map(repr, v)) + ")" for v in values).encode()
    return f"\n{len(values)}\n(".encode() + raw + b")\n"


def scalars(values: list[float], binary: bool) -> bytes:
    raw = struct.pack(f"<{len(values)}d", *values) if binary else "\n".join(map(repr, values)).encode()
    return f"\n{len(values)}\n(".encode() + raw + b")\n"


def write_mesh(case: Path, binary: bool, shift: float = 0.0) -> None:
    """constant/polyMesh; `shift` moves it along x [m]."""
    place = case / "constant/polyMesh"
    place.mkdir(parents=True)
    points = [(x + shift, float(y), float(z)) for x, y, z in POINTS]
    (place / "points").write_bytes(head("vectorField", binary) + vectors(points, binary))
    if binary:
        offsets = [4 * i for i in range(len(FACES) + 1)]
        faces = ints(offsets, True) + ints([p for f in FACES for p in f], True)
    else:
        rows = "\n".join("4(" + " ".join(map(str, f)) + ")" for f in FACES)
        faces = f"\n{len(FACES)}\n(\n{rows}\n)\n".encode()
    (place / "faces").write_bytes(head("faceCompactList" if binary else "faceList", binary) + faces)
    (place / "owner").write_bytes(head("labelList", binary) + ints(OWNER, binary))
    (place / "neighbour").write_bytes(head("labelList", binary) + ints(NEIGHBOUR, binary))
    (place / "boundary").write_bytes(head("polyBoundaryMesh", False) + BOUNDARY.encode())


def write_field(path: Path, values: list, binary: bool) -> None:
    """A volume field with a list of scalars or of 3-tuples."""
    path.parent.mkdir(parents=True, exist_ok=True)
    vector = isinstance(values[0], tuple)
    body = vectors(values, binary) if vector else scalars(values, binary)
    kind = "vector" if vector else "scalar"
    path.write_bytes(head(f"vol{kind.capitalize()}Field", binary) + b"dimensions [0 0 0 0 0 0 0];\n"
                     + f"internalField nonuniform List<{kind}> ".encode() + body
                     + b";\nboundaryField { ends { type zeroGradient; } }\n")


def write_particles(path: Path, rows: list[tuple], binary: bool = True) -> None:
    """Legacy VTK POLYDATA; rows are (x, y, z, id, radius, layer)."""
    path.parent.mkdir(parents=True, exist_ok=True)
    n = len(rows)

    def numbers(values: list, code: str) -> bytes:
        if binary:
            return struct.pack(f">{len(values)}{code}", *values) + b"\n"
        return (" ".join(map(repr, values)) + "\n").encode()

    raw = b"# vtk DataFile Version 3.0\nparticles\n" + (b"BINARY\n" if binary else b"ASCII\n")
    raw += b"DATASET POLYDATA\n" + f"POINTS {n} double\n".encode()
    raw += numbers([float(v) for r in rows for v in r[:3]], "d")
    raw += f"VERTICES {n} {2 * n}\n".encode() + numbers([v for i in range(n) for v in (1, i)], "i")
    raw += f"POINT_DATA {n}\nSCALARS id int 1\nLOOKUP_TABLE default\n".encode()
    raw += numbers([int(r[3]) for r in rows], "i")
    raw += b"SCALARS radius double 1\nLOOKUP_TABLE default\n" + numbers([float(r[4]) for r in rows], "d")
    raw += b"VECTORS velocity double\n" + numbers([0.5] * (3 * n), "d")
    raw += f"FIELD FieldData 1\nlayer 1 {n} int\n".encode() + numbers([int(r[5]) for r in rows], "i")
    path.write_bytes(raw)
