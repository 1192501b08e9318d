"""Scenes on a terrain profile: fluid mesh, wall and packed slide, all from one polyline.

`slidewave run` calls `prepare` for a case with a [geometry] table:

    profile        polylines (a .toml file below the case: failure, ground, bank)
    cell_size      nominal height and width of a fluid cell [m]
    slab_diameters width of the periodic slab over parameters.d_max, default 2; below that only with
                   `model linear`, whose history tells periodic images apart
    seat_shift     raises the seat of the failure surface [m], default 0
    split_x        x of the middle of the particle engine's box: where two ranks meet [m]
    pack_fraction  solid fraction of the packing before it settles, default 0.59
    seed           of the random packing, default 1

Files written: fluid/constant/polyMesh, the lake in fluid/0/alpha.water, dem/wall.stl,
for LAMMPS dem/wall.in too, and dem/slide.data.
"""

from pathlib import Path

from launch.errors import InputError

from . import files, half_spaces, mesh, slide
from .profile import Section, read_section

# Names of [parameters] that the geometry is made from, besides the scripts that use them.
PARAMETERS = ("lake_level", "d_min", "d_max", "particle_density", "coarse_grain")

KEYS = ("profile", "cell_size", "slab_diameters", "seat_shift", "split_x", "pack_fraction", "seed")


def prepare(case, run_dir: Path, say) -> None:
    """Writes everything that comes from the profile into a run directory that holds copies of the
    case's fluid/ and dem/. `say` prints a line of progress. Raises InputError for a bad profile."""
    _check(case)
    section = section_of(case)
    width = slab_width(case)
    fluid, dem = run_dir / "fluid", run_dir / "dem"
    if fluid.is_dir():
        columns = mesh.make_columns(section, case.get("geometry.cell_size"))
        made = mesh.make_mesh(columns, width)
        files.write_poly_mesh(made, fluid / "constant" / "polyMesh")
        lake = files.lake_fraction(made, section.lake_level)
        files.set_internal_field(fluid / "0" / "alpha.water", lake)
        say(f"  fluid mesh     {columns.cells} cells in {len(columns.low)} columns")
    # Exactly a period wide: wider, its periodic images overlap, and LIGGGHTS counts contacts with both.
    files.write_wall_stl(section, dem / "wall.stl", 0.0, width, longest=4.0 * width)
    if case.get("dem.engine") == "lammps":
        try:
            half_spaces.write(section.wall, dem / "wall.in")
        except ValueError as error:
            raise InputError(case.file, "geometry.profile", case.get("geometry.profile"), str(error)) from error
    slide.make(case, section, width, dem, say)


def section_of(case) -> Section:
    """The section of a case, with its lake, continued 3 D_max uphill of the crown."""
    path = case.directory / case.get("geometry.profile")
    try:
        return read_section(path, case.parameters["lake_level"], 3.0 * case.parameters["d_max"],
                            case.get("geometry.seat_shift", 0.0))
    except ValueError as error:
        raise InputError(case.file, "geometry.profile", case.get("geometry.profile"),
                         str(error)) from error


def slab_width(case) -> float:
    """Width of the periodic slab [m]."""
    return case.get("geometry.slab_diameters", 2.0) * case.parameters["d_max"]


def _is_number(value) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _check(case) -> None:
    for key in case.get("geometry"):
        if key not in KEYS:
            raise InputError(case.file, f"geometry.{key}", case.get(f"geometry.{key}"),
                             f"unknown key; known: {', '.join(KEYS)}")
    for name in ("lake_level", "d_min", "d_max", "particle_density"):
        if not isinstance(case.parameters.get(name), (int, float)):
            raise InputError(case.file, f"parameters.{name}", case.parameters.get(name),
                             "a scene with [geometry] needs this number")
    for key in ("profile", "cell_size", "split_x"):
        if case.get(f"geometry.{key}") is None:
            raise InputError(case.file, f"geometry.{key}", None, "is missing")
    size = case.get("geometry.cell_size")
    if not _is_number(size) or size <= 0:
        raise InputError(case.file, "geometry.cell_size", size, "give a positive length in m")
    slab = case.get("geometry.slab_diameters", 2.0)
    if not _is_number(slab) or slab <= 1:
        raise InputError(case.file, "geometry.slab_diameters", slab,
                         "give a number above 1: a particle would touch its own image")
    if not 0 < case.parameters["d_min"] <= case.parameters["d_max"]:
        raise InputError(case.file, "parameters.d_min", case.parameters["d_min"],
                         "give 0 < d_min <= d_max")
