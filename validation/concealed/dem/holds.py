"""What goes on in a hold: ageing of bonds, wear, swelling, temperature, wetting, a leak of the load.

Each function is a hold of `hours` that begins at the clock `start` [h] under a constant stress; it brings the specimen to rest after
each change, and calls `row(time)` where something is to be recorded.
"""

from collections.abc import Callable

import numpy as np

from dem.scene import O, Specimen
from dem.servo import Servo

Row = Callable[[float], None]
EVENTS = 60  # of ageing in a hold, at most
TOGETHER = 1.1  # bonds whose lives differ by less than this factor fail together
STEPS = 8  # of a gradual change in a hold
SETTLED = {"stretches": 2, "length": 300, "most": 80}  # rest between changes


def age(
    specimen: Specimen, servo: Servo, hours: float, start: float, row: Row, given: dict[str, float]
) -> None:
    """Charles' law: the strength c of a bond, as a share of its first one, falls by dc/dt = -(s/c)^n / t0 under a load s.

    given: `exponent` n and `reference_time` t0 [h]. Between two failures loads are constant, and
    lives known: t = t0/(n+1) s^-n (c^(n+1) - s^(n+1)).
    """
    clock, n, t0 = 0.0, given["exponent"], given["reference_time"]
    for _ in range(EVENTS):
        specimen.breaks()
        # One that has failed under pressure has no strength left, and may still be there.
        bonds = [b for b in specimen.intact if specimen.aged.get((b.id1, b.id2), 1.0) > 0]
        share = np.array([specimen.aged.get((bond.id1, bond.id2), 1.0) for bond in bonds])
        load = np.clip([_load(bond) for bond in bonds], 1e-3, 1) * share
        life = t0 / (n + 1) * load**-n * np.maximum(share ** (n + 1) - load ** (n + 1), 0)
        first = float(life.min()) * TOGETHER
        step = min(first, hours - clock)
        clock += step
        left = np.maximum(share ** (n + 1) - (n + 1) * step / t0 * load**n, 1e-30) ** (
            1 / (n + 1)
        )
        for bond, before, after, fails in zip(bonds, share, left, life <= step, strict=True):
            specimen.aged[bond.id1, bond.id2] = 0.0 if fails else float(after)
            specimen.weaken(bond, 0.0 if fails else float(after / before))
        row(start + clock)
        if clock >= hours:
            return
        servo.rest(**SETTLED)
        row(start + clock)
    row(start + hours)


def _load(bond) -> float:
    """Load of a bond as a share of its strength now, in tension or in shear."""
    phys, normal = bond.phys, bond.geom.normal
    tension = -phys.normalForce.dot(normal)
    shear = phys.shearForce.norm()
    friction = phys.tangensOfFrictionAngle * max(-tension, 0.0)
    return max(
        tension / max(phys.normalAdhesion, 1e-9),
        shear / max(phys.shearAdhesion + friction, 1e-9),
    )


def wet(
    specimen: Specimen, servo: Servo, hours: float, start: float, row: Row, given: dict[str, float]
) -> None:
    """At `at` [h] after the beginning of the hold all bonds lose the share `lost` of their strength."""
    row(start + given["at"])
    for bond in specimen.intact:
        specimen.weaken(bond, 1 - given["lost"])
    servo.rest()
    row(start + given["at"] * 1.02)
    row(start + hours)


def wear(
    specimen: Specimen, servo: Servo, hours: float, start: float, row: Row, given: dict[str, float]
) -> None:
    """Friction between grains falls with the logarithm of time, by the share `lost` in an e-fold from 0.1 h on."""
    before = 0.0
    for time in np.geomspace(0.02, 1, STEPS) * hours:
        worn = given["lost"] * np.log1p(time / 0.1)
        factor, before = (1 - worn) / (1 - before), worn
        for contact in specimen.contacts():
            contact.phys.tangensOfFrictionAngle *= factor
        servo.rest(**SETTLED)
        row(start + time)


def swell(
    specimen: Specimen, servo: Servo, hours: float, start: float, row: Row, given: dict[str, float]
) -> None:
    """Grains grow with the logarithm of time, by `growth` of their size in an e-fold from 0.1 h on."""
    _grow(servo, start, row, np.geomspace(0.02, 1, STEPS) * hours, given["growth"], np.log1p, 0.1)


def warm_and_cool(
    specimen: Specimen, servo: Servo, hours: float, start: float, row: Row, given: dict[str, float]
) -> None:
    """Days of warm and cold: grains grow and shrink by `amplitude` of their size."""
    count = max(int(hours / 3), 2)
    times = np.arange(1, count + 1) / count * hours
    _grow(servo, start, row, times, given["amplitude"], lambda t: np.sin(2 * np.pi * t), 24.0)


def _grow(
    servo: Servo,
    start: float,
    row: Row,
    times: np.ndarray,
    size: float,
    shape: Callable,
    unit: float,
) -> None:
    """Radii follow 1 + size x shape(time / unit)."""
    before = 1.0
    for time in times:
        now = 1 + size * float(shape(time / unit))
        for body in O.bodies:
            if body.id > 3:
                body.shape.radius *= now / before
        before = now
        servo.rest(**SETTLED)
        row(start + time)


def leak(
    specimen: Specimen, servo: Servo, hours: float, start: float, row: Row, given: dict[str, float]
) -> None:
    """The load falls by the share `lost` in the end, with the time `time` [h]; the gauge does not see it."""
    full = servo.target
    for time in np.geomspace(0.02, 1, STEPS) * hours:
        servo.aim(full * (1 - given["lost"] * -np.expm1(-time / given["time"])))
        servo.rest(**SETTLED)
        row(start + time)


HOLDS = {
    "bond_ageing": age,
    "wetting_collapse": wet,
    "friction_wear": wear,
    "grain_swelling": swell,
    "temperature_cycles": warm_and_cool,
    "load_leak": leak,
}
