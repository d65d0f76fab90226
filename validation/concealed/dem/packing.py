"""Packing of round grains, each a piece of a regular lattice of discs."""

import numpy as np
from scipy.optimize import minimize

SMALLEST, LARGEST = 13e-3, 19.1e-3  # diameters of grains [m]
TOUCHING = 2 - 1e-6  # distance of neighbours in a grain, in radii: never apart by round-off


def diameters(area: float, rng: np.random.Generator) -> np.ndarray:
    """Diameters [m] that fill `area` [m2]; richer in small grains than uniform."""
    found = []
    while area > 0.25 * np.pi * SMALLEST**2:
        found.append(SMALLEST + (LARGEST - SMALLEST) * rng.beta(1.0, 1.8))
        area -= 0.25 * np.pi * found[-1] ** 2
    return np.array(found)


def outlines(
    width: float, height: float, solid: float, rng: np.random.Generator
) -> tuple[np.ndarray, np.ndarray]:
    """Centres (n, 2) and radii (n,) [m] of circles without overlap in a box: grown until they jam."""
    radii = diameters(solid * width * height, rng) / 2
    centres = rng.random((len(radii), 2)) * [width, height]
    for scale in np.r_[np.linspace(0.5, 0.9, 5), np.linspace(0.92, 1.1, 37)]:
        moved = _spread(centres, scale * radii, width, height, rng)
        if moved is None:
            break
        centres, fitting = moved, scale * radii
    return centres, 0.999 * fitting


def _spread(
    centres: np.ndarray, radii: np.ndarray, width: float, height: float, rng: np.random.Generator
) -> np.ndarray | None:
    """Centres without overlap near the given ones; None if there are none to be found."""
    pairs = np.triu_indices(len(radii), 1)
    unit = radii.mean()

    def energy(flat: np.ndarray) -> tuple[float, np.ndarray]:
        x = flat.reshape(-1, 2) * unit
        apart = x[pairs[0]] - x[pairs[1]]
        distance = np.hypot(*apart.T) + 1e-12
        overlap = np.maximum(radii[pairs[0]] + radii[pairs[1]] - distance, 0)
        slope = np.zeros_like(x)
        push = (overlap / distance)[:, None] * apart
        np.add.at(slope, pairs[0], -push)
        np.add.at(slope, pairs[1], push)
        low = np.maximum(radii[:, None] - x, 0)
        high = np.maximum(x + radii[:, None] - [width, height], 0)
        total = 0.5 * ((overlap**2).sum() + (low**2).sum() + (high**2).sum())
        return total / unit**2, ((slope - low + high) / unit).ravel()

    for attempt in range(6):
        shaken = centres + 0.05 * attempt * unit * rng.standard_normal(centres.shape)
        found = minimize(
            energy, (shaken / unit).ravel(), jac=True, method="L-BFGS-B", options={"ftol": 1e-15}
        )
        if found.fun < 1e-7:
            return found.x.reshape(-1, 2) * unit
    return None


def elements(
    centres: np.ndarray, radii: np.ndarray, element: float, rng: np.random.Generator
) -> tuple[np.ndarray, np.ndarray]:
    """Centres (m, 2) [m] of discs of radius `element` inside the outlines, and the grain (m,) of each.

    A lattice of its own for each grain, turned and shifted at random, neighbours just touching.
    """
    places, grains = [], []
    for grain, (centre, radius) in enumerate(zip(centres, radii, strict=True)):
        count = int(radius / element) + 2
        i, j = np.mgrid[-count : count + 1, -count : count + 1]
        lattice = np.c_[(i + 0.5 * j).ravel(), (np.sqrt(0.75) * j).ravel()] * TOUCHING * element
        lattice += element * rng.random(2)
        angle = np.pi / 3 * rng.random()
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        inside = lattice[np.hypot(*lattice.T) <= radius - element]
        places.append(centre + inside @ turn.T)
        grains.append(np.full(len(inside), grain))
    return np.concatenate(places), np.concatenate(grains)
