"""The scene of in.setup for ESyS-Particle (dem.engine = "esys"): one sphere, no contact, gravity.

The run puts the values of case.toml in place as v_NAME; the defaults let stock esysparticle run it too."""

from math import pi

from esys.lsm import GravityPrms, LsmMpi, RotSphere
from esys.lsm.util import BoundingBox, Vec3

given = globals().get
diameter = given("v_diameter", 2e-3)
density = given("v_solid_density", 2500.0)
gravity = Vec3(given("v_gravity_x", 0.0), given("v_gravity_y", 0.0), given("v_gravity_z", -9.81))

sim = LsmMpi(numWorkerProcesses=1, mpiDimList=[1, 1, 1])
sim.initVerletModel(particleType="RotSphere", gridSpacing=3 * diameter, verletDist=0.2 * diameter)
sim.setTimeStepSize(given("v_dem_dt", 1e-4))
sim.setSpatialDomain(BoundingBox(Vec3(-0.03, -0.03, 0.0), Vec3(0.03, 0.03, 0.08)))
sim.createParticle(RotSphere(id=1, posn=Vec3(0.001, 0.001, given("v_start_height", 0.065)), radius=diameter / 2,
                             mass=density * pi / 6 * diameter**3))
sim.createInteractionGroup(GravityPrms(name="weight", acceleration=gravity))
