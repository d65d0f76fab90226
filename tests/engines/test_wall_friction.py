"""A column of discs in a rough ring, pressed from the top: what the base gets, against the formula of Janssen (1895)."""

import numpy as np
import pytest

import grus  # noqa: F401  first, since it loads YADE
from yade import O, utils
from yade.wrapper import BondLedger, BondMat, BondTimeStepper, GrainLoop, OedometerServo

RADIUS, ACROSS, ROWS = 5e-3, 6, 24
STIFFNESS, STRESS = 1e8, 100e3
MASS = 2500 * np.pi * RADIUS**2
"""Of a disc a metre thick [kg]."""


class Column:
    """Discs in closest packing between smooth platens, with walls of the friction coefficient `rough`; at rest."""

    def __init__(self, rough: float) -> None:
        O.reset()
        O.trackEnergy = True
        kinds = {"disc": 0.3, "side": rough, "platen": 0.0}
        for name, friction in kinds.items():
            O.materials.append(
                BondMat(
                    label=name,
                    density=2500,
                    kn=STIFFNESS,
                    ks=STIFFNESS,
                    frictionAngle=np.arctan(friction),
                    thickness=1,
                )
            )
        width, pitch = 2 * RADIUS * ACROSS, np.sqrt(3) * RADIUS
        height = 2 * RADIUS + pitch * (ROWS - 1)
        self.sides = self._walls(0, (0, width), "side")
        bottom, top = self._walls(1, (0, height), "platen")
        self.ids = []
        for row in range(ROWS):
            for column in range(ACROSS - row % 2):
                place = (RADIUS * (1 + 2 * column + row % 2), RADIUS + pitch * row, 0)
                disc = utils.sphere(place, RADIUS, material="disc")
                disc.state.blockedDOFs = "zXY"
                disc.state.mass = MASS
                disc.state.inertia = (MASS * RADIUS**2 / 2,) * 3
                disc.state.grain = len(self.ids)
                self.ids.append(O.bodies.append(disc))
        self.servo = OedometerServo(
            bottom=bottom,
            top=top,
            sides=self.sides,
            moving="top",
            area=width,
            sideBreadth=1.0,
            solidVolume=len(self.ids) * np.pi * RADIUS**2,
            ledger=BondLedger(),
            maxSpeed=5e-3,
            tolerance=1e-6,
            unbalancedLimit=1e-6,
            grainDiameter=2 * RADIUS,
            grainDensity=2500,
        )
        loop = GrainLoop(substeps=100, damping=0.4, ledger=self.servo.ledger, loading=[self.servo])
        stepper = BondTimeStepper()
        O.engines = [stepper, loop]
        O.dt = 0.3 * np.sqrt(MASS / (4 * STIFFNESS))
        stepper.dead = True
        self.width = width
        self.servo.begin(STRESS)
        O.run(400_000, True)
        assert self.servo.done

    def _walls(self, axis: int, places: tuple, material: str) -> list[int]:
        walls = [utils.wall(float(p), axis=axis, material=material) for p in places]
        for wall in walls:
            wall.state.isDamped = False
        return list(O.bodies.append(walls))

    def on_sides(self) -> tuple[np.ndarray, np.ndarray]:
        """Normal force and downward force [N] of each contact with a side wall, from the bottom."""
        found = []
        for i in O.interactions:
            if i.isReal and (i.id1 in self.sides or i.id2 in self.sides):
                # The force on the wall is the other way than on body 2, the disc.
                forces = (i.phys.normalForce.norm(), i.phys.shearForce[1])
                found.append((i.geom.contactPoint[1], *forces))
        return tuple(np.array(sorted(found))[:, 1:].T)


@pytest.fixture(scope="module", params=[0.05, 0.1, 0.2])
def rough(request) -> dict:
    """A column with rough walls: friction, stresses [Pa], width and height [m], forces on the sides [N]."""
    column = Column(request.param)
    s = column.servo
    normal, down = column.on_sides()
    return {
        "friction": request.param,
        "top": s.topStress,
        "base": s.bottomStress,
        "width": column.width,
        "height": s.height,
        "normal": normal,
        "down": down,
    }


@pytest.fixture(scope="module")
def smooth() -> tuple[float, float, float]:
    """Stresses on top, base and sides [Pa] of a column with smooth walls."""
    s = Column(0.0).servo
    return s.topStress, s.bottomStress, s.sideStress


def test_the_ring_carries_what_the_base_does_not_get(rough):
    """Equilibrium: (top - base) width = friction on both sides."""
    lost = (rough["top"] - rough["base"]) * rough["width"]
    assert lost > 0 and rough["down"].sum() == pytest.approx(lost, rel=1e-6)


def test_smooth_walls_lose_nothing(smooth):
    top, base, _ = smooth
    assert base == pytest.approx(top, rel=1e-6)


def test_friction_is_mobilised_but_for_the_lowest_discs(rough):
    """These are pushed up along the wall by the base."""
    share = rough["down"] / (rough["friction"] * rough["normal"])
    np.testing.assert_allclose(share[2:], 1, rtol=1e-6)
    np.testing.assert_allclose(share[:2], -1, rtol=1e-5)


def loss(rough: dict) -> tuple[float, float, float]:
    """Share of the top stress that is left above the lowest discs, the height of the column over them [m], and the lateral
    over the mean axial stress there."""
    above = rough["height"] - 2 * np.sqrt(3) * RADIUS
    force = rough["top"] * rough["width"]
    left = force - rough["down"][2:].sum()
    lateral = rough["normal"][2:].sum() / (2 * above)
    return left / force, above, lateral / ((force + left) / 2 / rough["width"])


def test_loss_is_that_of_janssen(rough):
    """d(stress)/dz = -friction K0 (2 / width) stress, with the lateral stress that was measured.

    The formula has one K0 over the height; what that leaves out is of third order in the exponent.
    """
    share, above, ratio = loss(rough)
    exponent = rough["friction"] * ratio * 2 * above / rough["width"]
    assert abs(np.log(share) + exponent) < exponent**3 / 10


def test_lateral_stress_of_the_smooth_column_predicts_the_loss(rough, smooth):
    """Friction raises the lateral stress, so that more is lost than the K0 of smooth walls has it: 2, 8 and 27 %."""
    share, above, _ = loss(rough)
    top, base, side = smooth
    exponent = rough["friction"] * side / ((top + base) / 2) * 2 * above / rough["width"]
    excess = -np.log(share) / exponent - 1
    assert 0 < excess < 1.5 * rough["friction"]
