"""`check` on every case of the repository, and on scenes broken in twenty ways: the quantity that is bad, the
key to change, and that the value that it names works."""

import json
import unittest

from launch import case as cases
from launch import ranks
from launch.places import ROOT
from tests.launch.scratch import command_line

COLUMN, POOL = "tests/cases/stability/column", "tests/cases/stability/pool"
SPHERE, TANK = "cases/settling_sphere", "cases/verification/standing_wave"
RESPONSE, MIXED = "response of the drag in a window, K W/m", "added-mass number rho_f phi/(rho_s eps)"
WAVE = "kernels that a contact wave runs in a window"
KN, WINDOW = "parameters.contact_stiffness", "coupling.window"

# Case, settings, the quantity that is bad, the key that is named.
BROKEN = {
    "contacts too stiff for the step": (COLUMN, [f"{KN}=1e5"], "particle step [s]", "parameters.dem_dt"),
    "particles too light for the step": (COLUMN, ["parameters.solid_density=1", "coupling.reaction=one_way"],
                                         "particle step [s]", "parameters.dem_dt"),
    "particles too small for the step": (POOL, ["parameters.diameter=1e-4"], "particle step [s]", "parameters.dem_dt"),
    "twelve contacts each": (COLUMN, ["parameters.lattice=fcc", "parameters.spacing=1.413e-3", f"{KN}=780"],
                             "particle step [s]", "parameters.dem_dt"),
    "a column too heavy": (COLUMN, ["physics.gravity=[0,0,-9.81]", f"{KN}=0.2"],
                           "overlap under the column's weight [D]", KN),
    "an impact too fast": (SPHERE, ["check.speed=2"], "overlap in the fastest impact [D]", KN),
    "particles that cross cells": (COLUMN, ["check.speed=3", f"{KN}=1000", "parameters.dem_dt=1e-6"],
                                   "cells crossed in a window", WINDOW),
    "mild and viscous": (COLUMN, ["coupling.regime=mild", "parameters.fluid_viscosity=1"], RESPONSE, WINDOW),
    "mild, a window too long": (COLUMN, ["coupling.regime=mild", "parameters.fluid_viscosity=0.02", "coupling.window=0.04"],
                                RESPONSE, WINDOW),
    "mild, in gas": (COLUMN, ["coupling.regime=mild", "parameters.fluid_density=1.3", "parameters.fluid_viscosity=0.1"],
                     RESPONSE, WINDOW),
    "beyond the stiff regime": (COLUMN, ["coupling.regime=stiff", "parameters.fluid_viscosity=1e10"], RESPONSE, WINDOW),
    "light particles": (COLUMN, ["parameters.solid_density=100", f"{KN}=3"], MIXED, "parameters.solid_density"),
    "light particles, mild": (COLUMN, ["coupling.regime=mild", "parameters.solid_density=60", "parameters.fluid_viscosity=1e-3",
                                       f"{KN}=3"], MIXED, "parameters.solid_density"),
    "a pile of nearly floating spheres": (COLUMN, ["parameters.lattice=fcc", "parameters.spacing=1.414e-3",
                                                   "parameters.solid_density=900", f"{KN}=10"],
                                          MIXED, "parameters.solid_density"),
    "contact waves too fast": (COLUMN, [f"{KN}=1e4", "parameters.dem_dt=1e-6", "parameters.fluid_viscosity=1e-3"], WAVE, WINDOW),
    "a Courant number too large": (COLUMN, ["check.speed=3", f"{KN}=1000", "parameters.dem_dt=1e-6"], "Courant number", WINDOW),
    "too large at a surface": (POOL, ["check.speed=6", f"{KN}=2000", "parameters.dem_dt=1e-6"],
                               "interface Courant number", "parameters.fluid_dt"),
    "a tank's step too long": (TANK, ["parameters.fluid_dt=1", "coupling.window=1.3"], "interface Courant number",
                               "parameters.fluid_dt"),
    "capillary waves": (POOL, ["parameters.surface_tension=70"], "fluid step over capillary step", "parameters.fluid_dt"),
    "cells much smaller than particles": (COLUMN, ["parameters.up=4", "parameters.layers=4", "parameters.cells_across=28",
                                                   "parameters.cells_up=50"],
                                          "cell size over largest diameter", "cell size of the mesh"),
    "a kernel too short": (COLUMN, ["coupling.smoothing_length=5e-4"], "smoothing length [m]", "coupling.smoothing_length"),
}


def check(case: str, variant: str, settings: list[str]) -> tuple[int, list[dict], str]:
    """Exit status, rows and messages of `check --json`."""
    words = [w for s in settings for w in ("--set", s)] + (["--variant", variant] if variant else [])
    engine = cases.load(str(ROOT / case), variant or None, settings).get("dem.engine")
    words += ["--ranks-fluid", "1", "--ranks-dem", str(ranks.FIXED_DEM_RANKS.get(engine, 1))]
    status, out, err = command_line("check", ROOT / case, "--json", *words)
    return status, json.loads(out) if out else [], err


class Broken(unittest.TestCase):
    """One test method a broken scene, made below."""

    def refused(self, name: str) -> None:
        case, settings, quantity, key = BROKEN[name]
        status, rows, err = check(case, "", settings)
        self.assertEqual(status, 1, err or rows)
        row = next(r for r in rows if r["quantity"] == quantity)
        self.assertEqual((row["verdict"], row["key"]), ("bad", key), row)
        self.assertTrue(row["source"])
        below = row["value"] < row["limit"]
        self.assertLess(row["margin"], 1)
        if key.split(".")[0] not in ("parameters", "coupling"):
            return
        works = row["works"] * (1.001 if below or key in (KN, "parameters.solid_density") else 0.999)
        value = float(f"{works:.6g}")
        fitting = [f"{key}={value!r}"]
        if key == WINDOW:  # particle step and end go with it
            fitting += [f"case.end_time={8 * value!r}", f"output.interval={8 * value!r}",
                        f"parameters.dem_dt={min(value / 4, 1e-7)!r}"]
        _, mended, err = check(case, "", settings + fitting)
        row = next(r for r in mended if r["quantity"] == quantity)
        self.assertNotEqual(row["verdict"], "bad", (fitting, row))


def _method(name: str):
    return lambda self: self.refused(name)


for _name in BROKEN:
    setattr(Broken, "test_" + "_".join(_name.replace(",", "").replace("'", "").split()), _method(_name))


class Repository(unittest.TestCase):
    """Every case and variant is sound, but for those that are there to be refused."""

    def test_every_case(self) -> None:
        files = sorted(f for place in ("cases", "tests/cases") for f in (ROOT / place).rglob("case.toml"))
        seen = 0
        for file in files:
            folder = str(file.parent.relative_to(ROOT))
            if "vajont" in folder:
                continue  # their slides take minutes to pack: test_vajont_ranks checks them
            data = cases.read_toml(file)
            for variant in ["", *data.get("variant", {})]:
                with self.subTest(case=folder, variant=variant):
                    status, rows, err = check(folder, variant, [])
                    if status == 2 and "not built" in err:
                        continue  # an optional engine
                    bad = [r for r in rows if r["verdict"] == "bad"]
                    self.assertEqual((status, bad), (0, []), err)
                    self.assertTrue(all(r["source"] for r in rows if r["limit"] is not None))
                    seen += 1
        self.assertGreater(seen, 15)


if __name__ == "__main__":
    unittest.main()
