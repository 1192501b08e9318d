"""The slide as it is at the moment of release: packed, settled, trimmed, seated, and cached.

No fluid program runs. slidewave_pack fills the space between failure surface and ground, the
case's scripts dem/in.settle and dem/in.seat bring it to rest, slidewave_pack trims it to the ground
in between. The wall is rough meanwhile (PREPARE_BASAL_ANGLE): on the wall's own angle the slope has
no state of rest, it is released by getting that angle.
"""

import hashlib
import json
import math
import os
import re
import shutil
import subprocess
import time
from pathlib import Path

import numpy as np

from launch import places, ranks
from launch.errors import RunError

PREPARE_BASAL_ANGLE = 45.0  # degrees
STEP_FRACTION = 0.35  # of sqrt(m_min / kn), as in the quick run
SETTLE_DRAG = 5.0  # viscous damping over mean mass [1/s]
SEAT_DRAG = 18.0
CONTACT_DAMPING = 0.3  # of critical
SCRIPTS = ("scene.in", "in.settle", "in.seat")
PACKED_BY = "slidewave_pack"


def make(case, section, width: float, dem: Path, say) -> dict:
    """Puts slide.data of a slab of `width` [m] into `dem`, from the cache where the same slide was made
    before. Gives its facts (particles, solid_fraction, ...)."""
    recipe = _recipe(case, section, width)
    key = _key(recipe, dem)
    kept = places.cache_dir() / f"slide-{key}"
    if not (kept / "facts.json").is_file():
        _make(case, section, recipe, dem, kept, say)
        origin = "prepared"
    else:
        origin = "from the cache"
    shutil.copyfile(kept / "slide.data", dem / "slide.data")
    facts = json.loads((kept / "facts.json").read_text())
    say(f"  slide          {facts['particles']} particles, porosity "
        f"{1 - facts['solid_fraction']:.3f}, {origin}")
    return facts


def _recipe(case, section, width) -> dict:
    """Every number that the slide depends on."""
    values = case.parameters
    mass = values["particle_density"] * math.pi / 6 * np.array(
        [values["d_min"] ** 3, _mean_cube(values["d_min"], values["d_max"])])
    kn = values["kn"]
    reach = max(case.get("geometry.split_x") - section.uphill_end,
                section.bank_end - case.get("geometry.split_x")) + values["d_max"]
    heights = np.concatenate([section.wall[:, 1], section.ground[:, 1]])
    return {
        "fill": {"least": values["d_min"], "most": values["d_max"],
                 "solid_fraction": case.get("geometry.pack_fraction", 0.59),
                 "margin": values["d_max"], "passes": 300, "seed": case.get("geometry.seed", 1)},
        "box": {"width": width, "density": values["particle_density"], "types": 2,
                "xlo": case.get("geometry.split_x") - reach,
                "xhi": case.get("geometry.split_x") + reach,
                "zlo": float(heights.min()) - 50, "zhi": float(heights.max()) + 150},
        "script": {"d_min": values["d_min"], "kn": kn, "kt": values["kt"],
                   "friction_angle": values["friction_angle"],
                   "basal_angle": PREPARE_BASAL_ANGLE, "toe": float(section.toe[0]),
                   "damping": CONTACT_DAMPING,
                   "prepare_dt": STEP_FRACTION * math.sqrt(mass[0] / kn),
                   **_gravity(case)},
        "settle": {"drag": SETTLE_DRAG * mass[1]},
        "seat": {"drag": SEAT_DRAG * mass[1], "lake_level": section.lake_level,
                 "water_density": values["water_density"]},
        "gap": values["d_max"],
        "wall": section.wall.tolist(),
        "ground": section.ground.tolist(),
    }


def _mean_cube(least, most):
    """Mean of D^3 for D uniform between least and most."""
    if most == least:
        return least**3
    return (most**4 - least**4) / (4 * (most - least))


def _gravity(case):
    x, y, z = (float(g) for g in case.get("physics.gravity"))
    return {"gravity": math.sqrt(x * x + y * y + z * z),
            "gravity_x": x, "gravity_y": y, "gravity_z": z}


def _key(recipe, dem):
    """Content hash of all inputs: numbers, scripts, and the program that packs."""
    digest = hashlib.sha256(json.dumps(recipe, sort_keys=True).encode())
    for name in SCRIPTS:
        digest.update((dem / name).read_bytes())
    digest.update((dem / "wall.stl").read_bytes())
    digest.update(_program(PACKED_BY).read_bytes())
    return digest.hexdigest()[:16]


def _program(name):
    path = places.program(name)
    if not path.is_file():
        raise RunError(f"{path} is missing: build first (./slidewave setup)")
    return path


def _make(case, section, recipe, dem, kept, say):
    """Runs the stages in a directory of their own, which becomes the cache entry when complete."""
    work = kept.with_name(f"{kept.name}.{os.getpid()}")
    work.mkdir(parents=True, exist_ok=True)
    start = time.monotonic()
    try:
        for name in (*SCRIPTS, "wall.stl"):
            shutil.copyfile(dem / name, work / name)
        for name in ("wall", "ground"):
            np.savetxt(work / f"{name}.txt", recipe[name], fmt="%.10g")
        lines = ["--base", "wall.txt", "--top", "ground.txt"]
        box = _options(recipe["box"])
        facts = _pack(work, "fill", lines + box + _options(recipe["fill"])
                      + ["--out", "packed.data"])
        say(f"  packing        {facts['particles']} spheres, largest overlap "
            f"{100 * facts['largest_overlap']:.1f} % of D")
        count = ranks.suggested(facts["particles"], ranks.PARTICLES_A_RANK)
        _stage(work, "in.settle", recipe["script"] | recipe["settle"], count, "settling", say)
        _pack(work, "trim", lines + box + ["--dump", "settled.dump", "--gap", str(recipe["gap"]),
                                           "--out", "trimmed.data"])
        _stage(work, "in.seat", recipe["script"] | recipe["seat"], count, "seating", say)
        facts = _pack(work, "convert", lines + box + ["--dump", "seated.dump",
                                                      "--out", "slide.data"])
        facts["prepare_s"] = time.monotonic() - start
        (work / "facts.json").write_text(json.dumps(facts) + "\n")
        if kept.exists():
            shutil.rmtree(kept)
        work.rename(kept)
    except BaseException:
        shutil.rmtree(work, ignore_errors=True)
        raise


def _options(values):
    return [word for name, value in values.items() for word in (f"--{name}", repr(value))]


def _pack(work, command, options):
    done = subprocess.run([str(_program(PACKED_BY)), command, *options], cwd=work,
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RunError(f"{PACKED_BY} {command} failed: {done.stderr.strip()}")
    return json.loads(done.stdout)


def _stage(work, script, variables, count, title, say):
    """Runs one script dry, with a line of progress every few seconds."""
    command = ["mpirun", "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1"]
    command += ["--allow-run-as-root"] if os.geteuid() == 0 else []
    command += ["--oversubscribe", "-np", str(count), str(_program("slidewave_dem")), "--script",
                script, "-log", "none"]
    for name, value in variables.items():
        command += ["-var", name, repr(value)]
    start = told = time.monotonic()
    text = []
    with subprocess.Popen(command, cwd=work, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True) as process:
        for line in process.stdout:
            text.append(line)
            row = re.fullmatch(r"\s+(\d+)\s+(\d+)\s+([\d.e+-]+)\s*", line)
            if row and time.monotonic() - told > 5:
                told = time.monotonic()
                seconds = int(row[1]) * variables["prepare_dt"]
                say(f"  {title:<14} {seconds:.1f} s of physical time, "
                    f"kinetic energy {float(row[3]):.2e} J")
    (work / f"log.{script}").write_text("".join(text))
    if process.returncode != 0:
        raise RunError(f"{script} failed (status {process.returncode}):\n{''.join(text[-12:])}")
    say(f"  {title:<14} {time.monotonic() - start:6.1f} s")
