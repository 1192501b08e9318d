"""Scenes of bench dem as LIGGGHTS scripts: a settled bed in a box and the dry slide, each with the
packaged linear law and with ours. Constants are those of the paper (kn 3e9, ks 2.7e9 N/m)."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

LEAST_M, MOST_M, DENSITY = 1.8, 3.8, 2650
SPACING_M = 3.85
WALLS = "zplane 0", "xplane 0", "xplane {w:.10g}", "yplane 0", "yplane {w:.10g}"
PACKAGED, OWN = "model hooke/stiffness tangential history", "model linear tangential coulomb"

HEAD = """units si
atom_style granular
atom_modify map array
boundary {boundary}
newton off
communicate single vel yes
{processors}
read_data {data}
neighbor {skin} bin
neigh_modify delay 0 contact_distance_factor {factor}
"""

PROPERTIES = """fix kn all property/global kn peratomtypepair {n} {kn}
fix kt all property/global kt peratomtypepair {n} {kt}
fix gn all property/global gamman peratomtypepair {n} {zero}
fix gt all property/global gammat peratomtypepair {n} {zero}
fix mu all property/global coefficientFriction peratomtypepair {n} {mu}
pair_style gran """ + PACKAGED + """
pair_coeff * *
"""


def bed_width(count: int) -> float:
    """Of the box of a bed [m]: about as high as a third of its width."""
    return (round(math.sqrt(count / 28)) + 0.5) * SPACING_M + 0.2


def write_data(file: Path, positions: np.ndarray, diameters: np.ndarray, width: float) -> None:
    """A LIGGGHTS data file of spheres."""
    low = f"0 {width:.17g} xlo xhi\n0 {width:.17g} ylo yhi\n-5 {40 * SPACING_M:.17g} zlo zhi\n"
    rows = "".join(f"{n + 1} 1 {d:.17g} {DENSITY} {x:.17g} {y:.17g} {z:.17g}\n"
                   for n, (d, (x, y, z)) in enumerate(zip(diameters, positions)))
    file.write_text(f"bed\n\n{len(diameters)} atoms\n1 atom types\n\n{low}\nAtoms\n\n{rows}")


def last_snapshot(dump: Path) -> np.ndarray:
    """id x y z radius of the last snapshot of a dump, by id."""
    rows = dump.read_text().rsplit("ITEM: ATOMS", 1)[1].split("\n", 1)[1].split()
    table = np.array(rows, dtype=float).reshape(-1, 5)
    return table[np.argsort(table[:, 0])]


def _walls(width: float, law: str, constants: str) -> str:
    return "".join(f"fix wall{n} all wall/gran {law} primitive type 1 {w.format(w=width)}{constants}\n"
                   for n, w in enumerate(WALLS))


def _own(width: float, more: str = "") -> str:
    constants = f" kn 3e9 ks 2.7e9 mu 0.577{more}"
    return f"pair_style gran {OWN}{constants}\npair_coeff * *\n" + _walls(width, OWN, constants)


def write_loose(place: Path, count: int) -> None:
    """Spheres on a face-centred lattice, and settle.in that lets them come to rest."""
    width = bed_width(count)
    side = int((width - 0.2) / SPACING_M)
    layer, k = np.divmod(np.arange(count), side * side)
    shift = 0.5 * SPACING_M * (layer % 2)
    places = np.column_stack([1.95 + SPACING_M * (k % side) + shift,
                              1.95 + SPACING_M * (k // side) + shift,
                              2 + SPACING_M * math.sqrt(0.5) * layer])
    diameters = np.random.default_rng(1).uniform(LEAST_M, MOST_M, count)
    write_data(place / "loose.data", places, diameters, width)
    head = HEAD.format(boundary="f f f", processors="", data="loose.data", skin=0.5, factor=1)
    (place / "settle.in").write_text(head + _own(width, " damping 0.3") + """
fix g all gravity 9.81 vector 0 0 -1
fix i all nve/sphere
timestep 4e-4
run 11000
fix drag all viscous 2e5
run 3000
dump last all custom 1 settled.dump id x y z radius
dump_modify last format "%d %.17g %.17g %.17g %.17g"
run 0
""")


def write_bed(place: Path, count: int) -> None:
    """bed.in for both laws, from bed.data."""
    width = bed_width(count)
    (place / "bed_own.in").write_text(_own(width))
    (place / "bed_packaged.in").write_text(
        PROPERTIES.format(n=1, kn="3e9", kt="2.7e9", zero="0", mu="0.577") + _walls(width, PACKAGED, ""))
    (place / "bed.in").write_text(
        "variable law index own\nvariable steps index 0\nvariable dumping index 0\nvariable factor index 1\n"
        + HEAD.format(boundary="f f f", processors="processors * * 1", data="bed.data", skin=0.2, factor="${factor}") + """
include bed_${law}.in
fix g all gravity 9.81 vector 0 0 -1
fix i all nve/sphere
timestep 1e-4
thermo 100000
run ${steps}
if "${dumping} == 1" then "dump last all custom 1 ${law}.dump id x y z radius" &
   "dump_modify last format '%d %.17g %.17g %.17g %.17g'" "run 0"
""")


def write_slide(place: Path, name: str, values: dict) -> None:
    """NAME.in for both laws, from slide.data and wall.stl of the prepared case in the folder NAME; `values`
    are the case's parameters."""
    grains, rock = (math.tan(math.radians(values[k])) for k in ("friction_angle", "basal_angle"))
    kn, kt = values["kn"], values["kt"]
    mesh = "fix terrain all mesh/surface file {name}/dem/wall.stl type 2\nfix wall all wall/gran {law} mesh n_meshes 1 meshes terrain{k}\n"
    own = f" kn {kn} ks {kt} mu "
    (place / f"{name}_own.in").write_text(
        f"pair_style gran {OWN}{own}{grains!r}\npair_coeff * *\n" + mesh.format(name=name, law=OWN, k=f"{own}{rock!r}"))
    (place / f"{name}_packaged.in").write_text(
        PROPERTIES.format(n=2, kn=f"{kn} " * 4, kt=f"{kt} " * 4, zero="0 0 0 0",
                          mu=f"{grains!r} {rock!r} {rock!r} {rock!r}") + mesh.format(name=name, law=PACKAGED, k=""))
    (place / f"{name}.in").write_text(
        "variable law index own\nvariable steps index 0\n"
        + HEAD.format(boundary="f p f", processors="processors * 1 1", data=f"{name}/dem/slide.data",
                      skin=0.4 * values["d_min"], factor=1)
        + f"""
include {name}_${{law}}.in
fix g all gravity 9.81 vector 0 0 -1
fix i all nve/sphere
timestep {values['dem_dt']}
thermo 100000
thermo_modify lost warn norm no
run ${{steps}}
""")
