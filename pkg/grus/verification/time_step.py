"""The critical time step of BondTimeStepper against that of the whole assembly."""

from collections.abc import Iterator
from math import acosh

import numpy as np
from yade import O
from yade.wrapper import BondTimeStepper, GlobalStiffnessTimeStepper

from grus.verification.assembly import Assembly
from grus.verification.block import hexagonal_block
from grus.verification.elastic import THICKNESS
from grus.verification.formulas import BondedPair
from grus.verification.free_scene import FreeScene
from grus.verification.row import Row, at_most, compare

PART = "time step"
RADIUS = 1e-3
CHAIN = 20
STABLE_STEPS = 500
SPEED = 1e-5  # of random motion at a stable step [m/s]
MODE_SPEED = 1e-11  # of a mode that grows [m/s] or [rad/s]
SPHERES, DISCS = (1 / 3, 2 / 3, 2 / 3), (0.6, 0.8, 0.0)  # direction of a chain


def time_step_rows() -> Iterator[Row]:
    """Critical step, stability below it, growth above it; then what YADE's own stepper says."""
    for assembly in assemblies():
        yield from _rows(assembly)
    yield from _stiffness_stepper_rows()


def assemblies() -> Iterator[Assembly]:
    """Pair, chain and block; contact bonds and parallel bonds without a contact beside them, so that pulling is as
    stiff as pressing and the system linear."""
    contact = BondedPair("contact", radii=(RADIUS, RADIUS))
    parallel = BondedPair("parallel", radii=(RADIUS, RADIUS), kn=0, ks=0)
    discs = BondedPair("parallel", thickness=THICKNESS, radii=(RADIUS, RADIUS), kn=0, ks=0)
    for pair in (contact, parallel, discs):
        what = f"{pair.kind} bonds, {'discs' if pair.thickness else 'spheres'}"
        line = 2 * RADIUS * np.array(DISCS if pair.thickness else SPHERES)
        block = hexagonal_block(RADIUS)
        if pair.thickness:
            block = block[block[:, 2] == 0]
        yield Assembly(f"{what}: pair", np.arange(2)[:, None] * line, pair)
        yield Assembly(f"{what}: chain of {CHAIN}", np.arange(CHAIN)[:, None] * line, pair)
        yield Assembly(f"{what}: close packing of {len(block)}", block, pair)


def _rows(assembly: Assembly) -> Iterator[Row]:
    exact, shape = assembly.highest_mode()
    scene = FreeScene(assembly, assembly.random_motion(SPEED))
    stepper = BondTimeStepper(safety=0.95)
    yield at_most(
        PART,
        assembly.name,
        "critical step",
        "s",
        exact,
        stepper.critical(),
        1e-9,
        "2 / omega_max from the eigenvalues of the stiffness matrix of the whole assembly. BondTimeStepper takes a "
        "bound from each body, which may be smaller, never larger.",
    )
    scene.set_step(stepper)
    energy = scene.kept_energy(STABLE_STEPS)
    yield compare(
        PART,
        assembly.name,
        f"change of energy in {STABLE_STEPS} steps, safety 0.95",
        "1",
        0,
        np.abs(energy / energy[0] - 1).max(),
        1e-5,
        "Central differences keep elastic energy plus m v(-1/2) v(+1/2) / 2 of a linear system at every stable step.",
    )
    for factor in (1.01, 1.2) if len(assembly.centres) == 2 else (1.01,):
        scene = FreeScene(assembly, MODE_SPEED * shape)
        rate = 4 * acosh(factor)
        yield compare(
            PART,
            assembly.name,
            f"growth of energy in a step {factor:g} times the exact one",
            "1",
            rate,
            scene.growth(factor * exact, round(24 / rate)),
            1e-3,
            "Logarithmic: a mode with omega dt = 2 f grows by exp(2 acosh f) a step; begun in the highest mode.",
        )


def _stiffness_stepper_rows() -> Iterator[Row]:
    """YADE's GlobalStiffnessTimeStepper on a block whose bonds are stiffer than its contacts."""
    pair = BondedPair("parallel", radii=(RADIUS, RADIUS), kn=4e5, ks=3e5)
    assembly = Assembly("block", hexagonal_block(RADIUS), pair)
    exact, _ = assembly.highest_mode()
    scene = FreeScene(assembly, np.zeros((len(assembly.centres), 6)))
    fresh = scene.set_step(_stiffness_stepper())
    scene = FreeScene(assembly, assembly.random_motion(SPEED))
    O.dt = exact / 10
    O.step()
    O.step()
    loaded = scene.set_step(_stiffness_stepper())
    case = "GlobalStiffnessTimeStepper, parallel bonds, block of 100"
    yield compare(
        PART,
        f"{case}: just bonded",
        "time step",
        "s",
        exact,
        fresh,
        None,
        "Contacts without normal force are skipped, here all of them; what is left is R sqrt(density / young), in "
        "which young plays no part in these contacts. Not to be used with bonds.",
    )
    yield compare(
        PART,
        f"{case}: under load",
        "time step",
        "s",
        exact,
        loaded,
        None,
        "Only the contact's kn and ks are seen, not those of the bond beside it.",
    )


def _stiffness_stepper() -> GlobalStiffnessTimeStepper:
    return GlobalStiffnessTimeStepper(timestepSafetyCoefficient=1, maxDt=1)
