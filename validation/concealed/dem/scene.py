"""The specimen in YADE: bonded discs between two platens and two side walls, in the plane x-y."""

import math
from pathlib import Path

import numpy as np
from grus.host.load import import_yade

from dem.packing import elements, outlines

yade = import_yade()
O, utils, wrapper = yade.O, yade.utils, yade.wrapper

# The box that grains are placed in [m]; closing takes a quarter of its height.
WIDTH, HEIGHT = 0.074, 0.084
SOLID = 0.78  # share of it inside the outlines
DENSITY = 2052.0  # of discs of unit thickness [kg/m3]
STIFFNESS = 1.2e9  # of a contact [N/m], times the factor of the material
# Strength of a bond over its width of two radii [Pa], times the factor of the material.
TENSION = 0.28e6
SHEAR = 2.0  # shear strength over that in tension
STRONG = 1e12  # strength in the preparation [N]
PREPARATION_FRICTION = 0.0
DAMPING = 0.5
HEXAGONAL = math.pi / math.sqrt(12)  # share of a grain inside its elements


class Specimen:
    """Bodies, bonds and engines of one specimen; SI units, compression positive.

    stiffness: factor. element: radius of the elements [m]. seed: of packing and lattices. Bonds are too strong to break
    until `begin`.
    """

    def __init__(self, stiffness: float, element: float, seed: int):
        O.reset()
        self.element, self.rolling, self.aged = element, 0.0, {}
        rng = np.random.default_rng([seed, 3])
        centres, radii = outlines(WIDTH, HEIGHT, SOLID, rng)
        places, grains = elements(centres, radii, element, rng)
        places -= places.min(axis=0) - element
        width, height = (places.max(axis=0) + element).tolist()
        self._materials(stiffness)
        self._walls(width, height)
        for place in places:
            self._disc(place, element)
        self.grains = dict(zip(range(4, 4 + len(grains)), grains.tolist(), strict=True))
        self.width = width
        self._engines()
        self._bond()

    def _materials(self, stiffness: float) -> None:
        # The stiffness of a contact of two equal discs is young x radius.
        young = STIFFNESS * stiffness / self.element
        friction = math.atan(PREPARATION_FRICTION)
        common = {"young": young, "poisson": 1.0, "density": DENSITY, "frictionAngle": friction}
        discs = wrapper.CohFrictMat(
            isCohesive=True,
            normalCohesion=1.0,  # set bond by bond
            shearCohesion=1.0,
            momentRotationLaw=True,
            alphaKr=0.3,
            alphaKtw=0.0,
            **common,
        )
        O.materials.append(discs)
        O.materials.append(wrapper.FrictMat(**{**common, "frictionAngle": 0.0}))
        O.materials.append(wrapper.FrictMat(**common))

    def _walls(self, width: float, height: float) -> None:
        """Bodies 0 to 3: left, right, base, top."""
        for axis, ends, material in ((0, (0.0, width), 1), (1, (0.0, height), 2)):
            for end in ends:
                O.bodies.append(utils.wall(end, axis=axis, material=O.materials[material]))

    def _disc(self, place: np.ndarray, radius: float) -> None:
        centre = (float(place[0]), float(place[1]), 0.0)
        body = utils.sphere(centre, radius, material=O.materials[0], color=(1, 1, 1))
        mass = DENSITY * math.pi * radius**2
        body.state.mass = mass
        body.state.inertia = (mass * radius**2 / 2,) * 3
        body.state.blockedDOFs = "zXY"
        O.bodies.append(body)

    def _engines(self) -> None:
        mass = DENSITY * math.pi * self.element**2
        O.dt = 0.32 * math.sqrt(mass / (O.materials[0].young * self.element))
        O.engines = [
            wrapper.ForceResetter(),
            wrapper.InsertionSortCollider(
                [wrapper.Bo1_Sphere_Aabb(), wrapper.Bo1_Wall_Aabb()],
                verletDist=0.15 * self.element,
            ),
            wrapper.InteractionLoop(
                [wrapper.Ig2_Sphere_Sphere_ScGeom6D(), wrapper.Ig2_Wall_Sphere_ScGeom()],
                [
                    wrapper.Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionNow=True),
                    wrapper.Ip2_FrictMat_FrictMat_FrictPhys(),
                ],
                [
                    wrapper.Law2_ScGeom6D_CohFrictPhys_CohesionMoment(useIncrementalForm=True),
                    wrapper.Law2_ScGeom_FrictPhys_CundallStrack(),
                ],
            ),
            wrapper.NewtonIntegrator(damping=DAMPING),
        ]

    def _bond(self) -> None:
        """Bonds at all contacts of discs there are: those inside grains, since outlines do not overlap."""
        O.step()
        self.bonds = [i for i in O.interactions if i.isReal and min(i.id1, i.id2) > 3]
        for bond in self.bonds:
            bond.phys.normalAdhesion = bond.phys.shearAdhesion = STRONG
            bond.phys.maxRollPl = -1  # elastic
        self.intact = list(self.bonds)

    def begin(
        self, strength: float, friction: float, wall_friction: float = 0.0, rolling: float = 0.0
    ) -> None:
        """From the state of the preparation to that of the test. rolling: coefficient of rolling friction."""
        tension = TENSION * strength * 2 * self.element
        for bond in self.bonds:
            bond.phys.normalAdhesion = tension
            bond.phys.shearAdhesion = SHEAR * tension
        self.rolling = rolling
        discs, sides, platens = O.materials
        if rolling:
            discs.etaRoll = rolling
            O.engines[2].lawDispatcher.functors[0].always_use_moment_law = True
        discs.frictionAngle = platens.frictionAngle = math.atan(friction)
        sides.frictionAngle = math.atan(wall_friction)
        for i in O.interactions:
            if i.isReal:
                side = min(i.id1, i.id2) < 2
                i.phys.tangensOfFrictionAngle = wall_friction if side else friction
        if rolling:
            for i in self.contacts():
                i.phys.maxRollPl = rolling * self.element

    def scatter_strength(self, variation: float, seed: int) -> None:
        """Strengths of bonds drawn from a Weibull distribution of mean 1 and this coefficient of variation."""
        rng = np.random.default_rng([seed, 4])
        modulus = variation**-1.086
        mean = math.gamma(1 + 1 / modulus)
        for bond in self.bonds:
            self.weaken(bond, float(rng.weibull(modulus)) / mean)

    @staticmethod
    def weaken(bond, factor: float) -> None:
        """Multiplies the strengths of a bond."""
        bond.phys.normalAdhesion *= factor
        bond.phys.shearAdhesion *= factor

    def breaks(self) -> int:
        """Bonds broken so far."""
        whole = [bond.isReal and not bond.phys.cohesionBroken for bond in self.intact]
        if self.rolling:
            for bond, kept in zip(self.intact, whole, strict=True):
                if bond.isReal and not kept:
                    bond.phys.maxRollPl = self.rolling * self.element
        self.intact = [bond for bond, kept in zip(self.intact, whole, strict=True) if kept]
        return len(self.bonds) - len(self.intact)

    def contacts(self) -> list:
        """Contacts of discs of different grains."""
        return [
            i
            for i in O.interactions
            if i.isReal and min(i.id1, i.id2) > 3 and self.grains[i.id1] != self.grains[i.id2]
        ]

    @property
    def height(self) -> float:
        return float(O.bodies[3].state.pos[1] - O.bodies[2].state.pos[1])

    def stresses(self) -> tuple[float, float, float]:
        """On the top platen, the base, and the mean of the sides [Pa]."""
        left, right, base, top = (O.forces.f(wall) for wall in range(4))
        lateral = 0.5 * (right[0] - left[0]) / self.height
        return top[1] / self.width, -base[1] / self.width, lateral

    @property
    def void_ratio(self) -> float:
        """Of the grains as the lattice fills them."""
        solid = len(self.grains) * math.pi * self.element**2 / HEXAGONAL
        return self.width * self.height / solid - 1

    def save(self, path: Path) -> None:
        """The prepared specimen; without the servo, which is Python."""
        O.save(str(path))
        ids = [(bond.id1, bond.id2) for bond in self.bonds]
        np.savez(path.with_suffix(".npz"), bonds=ids, grains=list(self.grains.values()))

    @classmethod
    def load(cls, path: Path, element: float) -> "Specimen":
        O.reset()
        O.load(str(path))
        stored = np.load(path.with_suffix(".npz"))
        self = cls.__new__(cls)
        self.element, self.rolling, self.aged = element, 0.0, {}
        self.grains = dict(zip(range(4, len(O.bodies)), stored["grains"].tolist(), strict=True))
        self.width = float(O.bodies[1].state.pos[0] - O.bodies[0].state.pos[0])
        self.bonds = [O.interactions[a, b] for a, b in stored["bonds"].tolist()]
        self.intact = list(self.bonds)
        return self
