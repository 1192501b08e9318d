"""Drag of spheres in beds, written down here from the publications and from nothing of slidewave's."""

from __future__ import annotations

import math

import numpy as np


def volume(diameter: float) -> float:
    """[m3]"""
    return math.pi / 6 * diameter**3


def brown_lawler_cd_re(re: float) -> float:
    """Cd Re of one sphere, Brown and Lawler (2003)."""
    return 24 * (1 + 0.15 * re**0.681) + 0.407 * re / (1 + 8710 / re)


def dalla_valle_cd_re(re: float) -> float:
    """Cd Re of one sphere, Dalla Valle (1948), the coefficient that Di Felice used."""
    return (0.63 * math.sqrt(re) + 4.8) ** 2


def di_felice(eps: float, slip: float, diameter: float, density: float, viscosity: float,
              cd_re=brown_lawler_cd_re) -> float:
    """K [kg/s] in formulation A, Di Felice (1994): drag over interstitial slip, with the superficial
    Reynolds number in Cd and exponent."""
    re = max(eps * density * diameter * abs(slip) / viscosity, 1e-12)
    chi = 3.7 - 0.65 * math.exp(-0.5 * (1.5 - math.log10(re)) ** 2)
    return math.pi / 8 * diameter * viscosity * cd_re(re) * eps ** (1 - chi)


def stokes_viscosity(drag: float, eps: float, diameter: float) -> float:
    """Viscosity [Pa s] at which K is `drag` as the slip goes to zero."""
    return drag / (3 * math.pi * diameter * eps**-2.7)


def darcy_pressure(eps: np.ndarray, flux: float, cell: float, diameter: float, density: float,
                   viscosity: float, cd_re=brown_lawler_cd_re) -> float:
    """Pressure difference [Pa] over cells of height `cell` for a superficial velocity `flux` through
    resting spheres that fill 1 - eps: -eps dp/dz = n K u, one law a cell."""
    total = 0.0
    for e in np.atleast_1d(eps):
        number = (1 - e) / volume(diameter)
        total += cell * number * di_felice(e, flux / e, diameter, density, viscosity, cd_re) * flux / e / e
    return total
