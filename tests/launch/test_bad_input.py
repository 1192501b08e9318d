"""Broken cases: each is refused with exit status 2 before anything is started, the message names
file, key, value and remedy, and no run directory is left behind."""

import unittest

from tests.launch.scratch import ScratchCase

TOML, SCRIPT, FLUID = "case.toml", "dem/in.setup", "fluid/"

# name: file, text, its replacement, what the message must hold
BROKEN = {
    "unknown key": (TOML, "reaction = ", "reactoin = ", ["case.toml", "coupling.reactoin", "two_way",
                                                         "did you mean 'coupling.reaction'"]),
    "unknown table": (TOML, "[output]", "[outptu]", ["outptu.interval", "output.interval"]),
    "wrong type": (TOML, "window = 5e-4 ", 'window = "5e-4" ', ["coupling.window", "'5e-4'", "number [s]"]),
    "wrong sign": (TOML, "window = 5e-4 ", "window = -5e-4 ", ["coupling.window", "-0.0005", "above 0"]),
    "not finite": (TOML, "end_time = 0.1", "end_time = inf", ["case.end_time", "inf", "finite"]),
    "not a vector": (TOML, "[0, 0, -9.81]", "-9.81", ["physics.gravity", "three numbers"]),
    "unknown choice": (TOML, '"two_way"\nsmoothing', '"twoway"\nsmoothing',
                       ["coupling.reaction", "twoway", "did you mean 'two_way'"]),
    "missing key": (TOML, "window = 5e-4 ", "# ", ["coupling.window", "missing", "[s]"]),
    "not toml": (TOML, "[coupling]", "[coupling", ["case.toml", "line 11"]),
    "table as value": (TOML, "[case]\n", "models = 3\n\n[case]\n", ["models", "3", "[models]"]),
    "unknown observer": (TOML, 'type = "particle"', 'type = "particel"',
                         ["observe.sphere.type", "did you mean 'particle'"]),
    "observer key": (TOML, "id = 1", "ident = 1", ["observe.sphere.ident", "known: id"]),
    "observer needs": (TOML, "id = 1", "", ["observe.sphere.id", "missing"]),
    "no such variant": (TOML, 'variant = "two_way"', 'variant = "two_wya"',
                        ["two_wya", "did you mean 'two_way'"]),
    "bad variant not chosen": (TOML, "parameters.dem_dt = 2.2e-3", "parameters.dem_dt = -1",
                               ["parameters.dem_dt", "-1", "above 0"]),
    "window does not divide": (TOML, "end_time = 0.1", "end_time = 0.10013",
                               ["case.end_time", "0.10013", "0.0005", "0.1"]),
    "window beyond the end": (TOML, "end_time = 0.1", "end_time = 1e-4", ["coupling.window", "longer"]),
    "output between windows": (TOML, "interval = 0.02", "interval = 0.0207",
                               ["output.interval", "0.0207", "e.g. 0.0205"]),
    "step beyond the window": (TOML, "dem_dt = 1e-4 ", "dem_dt = 1e-3 ", ["parameters.dem_dt", "0.001"]),
    "unused parameter": (TOML, "[parameters]", "[parameters]\nfluid_colour = 3",
                         ["parameters.fluid_colour", "3", "no side uses it"]),
    "reserved name": (TOML, "[parameters]", "[parameters]\nend_time = 3", ["parameters.end_time"]),
    "unknown name in text": (TOML, "interval = 0.02", 'interval = "$intervall"', ["$intervall"]),
    "missing script": (TOML, "dem/in.setup", "dem/in.setpu", ["dem.script", "dem/in.setpu", "no such file"]),
    "script elsewhere": (TOML, "dem/in.setup", "../in.setup", ["dem.script", "must lie in dem/"]),
    "target without source": (TOML, 'source = "undisturbed', '# "undisturbed', ["target 'terminal", "source"]),
    "target key": (TOML, "tolerance = 0.013", "tolerence = 0.013", ["tolerence", "target.tolerance"]),
    "literal repeats parameter": (FLUID + "constant/transportProperties", "$fluid_density;",
                                  "1000;\nfluid_density 998;", ["transportProperties:", "fluid_density",
                                                                "998", "$fluid_density"]),
    "script redefines parameter": (SCRIPT, "variable diameter index 2e-3", "variable diameter equal 3e-3",
                                   ["in.setup:3", "diameter", "${diameter}"]),
    "gravity repeated": (SCRIPT, "gravity ${gravity} vector", "gravity 9.81 vector",
                         ["in.setup", "gravity", "9.81"]),
    "gravity disagrees, particles": (SCRIPT, "gravity ${gravity} vector", "gravity 9.8 vector",
                                     ["in.setup", "9.8", "disagree"]),
    "gravity disagrees, fluid": (FLUID + "constant/g", "$gravity", "(0 -9.80665 0)", ["g", "disagree"]),
    "end time disagrees": (FLUID + "system/controlDict", "$end_time", "0.25",
                           ["controlDict", "endTime", "0.25", "$end_time"]),
    "periodic width": (SCRIPT, "-0.03 0.03 -0.03 0.03", "-0.03 0.03 -0.0015 0.0015",
                       ["periodic width in y", "0.003", "at least 0.004"]),
    "contact scaling of a packaged law": (TOML, "[parameters]", '[models]\ncontact_scaling = "sakai"\n[parameters]',
                                          ["models.contact_scaling", "sakai", "model linear"]),
    "unknown contact scaling": (TOML, "[parameters]", '[models]\ncontact_scaling = "sakia"\n[parameters]',
                                ["models.contact_scaling", "sakia", "none, proportional, sakai"]),
    "periodicity disagrees": (SCRIPT, "boundary        f f f", "boundary        f p f",
                              ["boundary", "periodic in y", "the mesh is not"]),
    "mesh does not cover": (SCRIPT, "0.001 0.001 ${start", "0.001 0.031 ${start",
                            ["coupling.outside", "1 of 1 particles", "extend the mesh"]),
    "mesh does not cover, low side": (SCRIPT, "0.001 0.001 ${start", "0.001 -0.031 ${start",
                                      ["coupling.outside", "(0.001 -0.031 0.04)"]),
    "prescribed flow, two-way": (TOML, '[dem]\n', '[fluid]\nengine = "uniform_flow"\n[dem]\n',
                                 ["coupling.reaction", "two_way", "takes no momentum", "one_way"]),
    "prescribed flow without density": (TOML, 'reaction = "two_way"\nsmoothing_length = 6e-3   # three diameters\n',
                                        'reaction = "one_way"\n[fluid]\nengine = "uniform_flow"\n',
                                        ["uniform_flow.density", "missing"]),
    "both sides none": (TOML, '[dem]\n', '[fluid]\nengine = "none"\n[dem]\nengine = "none"\n', ["empty"]),
}


class BadInput(ScratchCase):
    """One test method a broken case, made below."""

    def refused(self, name: str) -> None:
        file, old, new, expected = BROKEN[name]
        self.change(file, old, new)
        if name == "periodic width":
            self.change(SCRIPT, "boundary        f f f", "boundary        f p f")
        status, _, err = self.dry_run()
        self.assertEqual(status, 2, err)
        for text in expected:
            self.assertIn(text, err)
        self.assertFalse((self.place / "run").exists(), "a refused case left a run directory")

    def test_missing_fluid_file(self) -> None:
        (self.case / "fluid/system/fvSchemes").unlink()
        status, _, err = self.dry_run()
        self.assertEqual(status, 2)
        self.assertIn("fvSchemes", err)

    def test_no_mesh(self) -> None:
        (self.case / "fluid/system/blockMeshDict").unlink()
        status, _, err = self.dry_run()
        self.assertEqual(status, 2)
        self.assertIn("no mesh", err)

    def test_empty_scene(self) -> None:
        self.change(TOML, "[dem]\n", '[fluid]\nengine = "none"\n[dem]\n')
        self.change(SCRIPT, "create_atoms    1 single 0.001 0.001 ${start_height} units box", "print ${start_height}")
        status, _, err = self.dry_run()
        self.assertEqual(status, 2)
        self.assertIn("makes no particle", err)

    def test_no_such_case(self) -> None:
        status, _, err = self.slidewave("check", "cases/setling_sphere")
        self.assertEqual(status, 2)
        self.assertIn("did you mean 'settling_sphere'", err)

    def test_unbroken_case_is_accepted(self) -> None:
        status, out, err = self.dry_run()
        self.assertEqual(status, 0, err)
        self.assertIn("mpirun", out)


def _method(name: str):
    return lambda self: self.refused(name)


for _name in BROKEN:
    setattr(BadInput, "test_" + _name.replace(" ", "_").replace(",", ""), _method(_name))

if __name__ == "__main__":
    unittest.main()
