"""A settling sphere by itself: what the coupled run must give, worked out without any of its code."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq


@dataclass
class Sphere:
    """diameter [m], densities of sphere and fluid [kg/m3], viscosity [Pa s], gravity [m/s2]."""

    diameter: float
    solid_density: float
    fluid_density: float
    fluid_viscosity: float
    gravity: float = 9.81

    @property
    def volume(self) -> float:
        return np.pi / 6 * self.diameter**3

    @property
    def mass(self) -> float:
        return self.solid_density * self.volume

    def drag(self, speed: float) -> float:
        """Drag [N] at a speed [m/s]: Brown and Lawler (2003), Cd = 24/Re (1 + 0.15 Re^0.681) +
        0.407/(1 + 8710/Re)."""
        if speed == 0:
            return 0.0
        re = self.fluid_density * abs(speed) * self.diameter / self.fluid_viscosity
        cd = 24 / re * (1 + 0.15 * re**0.681) + 0.407 / (1 + 8710 / re)
        return cd * np.pi / 8 * self.fluid_density * self.diameter**2 * abs(speed) * speed

    @property
    def submerged_weight(self) -> float:
        return (self.solid_density - self.fluid_density) * self.volume * self.gravity

    def terminal_speed(self) -> float:
        """Speed at which drag carries the submerged weight [m/s]."""
        return brentq(lambda v: self.drag(v) - self.submerged_weight, 1e-9, 1e3, xtol=1e-15)

    def speed(self, times: np.ndarray) -> np.ndarray:
        """Downward speed from rest at ascending times [m/s], without added mass and history force."""
        done = solve_ivp(lambda _, v: [(self.submerged_weight - self.drag(v[0])) / self.mass],
                         (0, float(times[-1])), [0.0], t_eval=times, rtol=1e-10, atol=1e-14,
                         method="Radau")
        return done.y[0]

    def self_disturbance(self, time: float, smoothing_length: float) -> float:
        """Excess of terminal speed, relative, when the sphere's own reaction moves the fluid that its
        drag sees. Unsteady Stokes flow by a constant force through a Gaussian kernel of standard
        deviation s = L/sqrt(2), seen through the same kernel, unbounded fluid:
        u = F/(6 pi^1.5 mu) (1/s - 1/sqrt(s^2 + nu t)), over the terminal F/(3 pi mu d)."""
        s = smoothing_length / np.sqrt(2)
        nu = self.fluid_viscosity / self.fluid_density
        return self.diameter / (2 * np.sqrt(np.pi)) * (1 / s - 1 / np.sqrt(s**2 + nu * time))
