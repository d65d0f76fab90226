"""Platens that are too fast: the inertial number, and inertia as the difference of the forces on both platens."""

from math import sqrt

import pytest
from box import Box
from scenes import engine
from yade import O
from yade.wrapper import NewtonIntegrator

STRONG = {"bond__tensile_strength": "1 GPa", "bond__shear_strength": "1 GPa"}


@pytest.fixture(params=["both", "top"])
def fast(request) -> Box:
    """A column that is pressed at 1 m/s, without damping."""
    box = Box(servo={"maxSpeed": 1.0, "moving": request.param}, **STRONG)
    engine(NewtonIntegrator).damping = 0
    box.servo.begin(10e6)
    return box


def momentum() -> float:
    """Of all grains along the axis of loading [N s]."""
    own = [body for body in O.bodies if not body.isClumpMember]
    return sum(body.state.mass * body.state.vel[1] for body in own if body.state.mass > 0)


def test_forces_on_the_platens_differ_by_the_change_of_momentum(fast):
    impulse, largest = -momentum(), 0.0
    for _ in range(300):
        O.step()
        impulse -= sum(O.forces.f(platen)[1] for platen in fast.walls[1]) * O.dt
        largest = max(largest, abs(impulse))
    assert largest > 0 and momentum() == pytest.approx(impulse, abs=1e-6 * largest)


def test_only_the_top_moves_over_a_fixed_base():
    box = Box(servo={"moving": "top"}, **STRONG)
    before = O.bodies[box.walls[1][0]].state.pos[1]
    box.stage(100e3)
    assert O.bodies[box.walls[1][0]].state.pos[1] == before
    assert box.servo.topStress == pytest.approx(100e3, rel=0.01)
    assert box.servo.bottomStress == pytest.approx(100e3, rel=0.01)  # the sides are smooth


def test_inertial_number_is_that_of_the_formula(fast):
    """rate d sqrt(density / p), the rate from look to look (GDR MiDi 2004)."""
    s = fast.servo
    looks = []
    for _ in range(6):
        O.run(s.lookInterval - (O.iter - 1) % s.lookInterval, True)
        base = 0.5 * (s.topStress + s.bottomStress)
        looks.append((O.time, s.height, s.topStress if s.moving == "top" else base, s.inertial))
    assert max(look[3] for look in looks) > 1e-3  # too fast
    for (t0, h0, _, _), (t1, h1, stress, found) in zip(looks, looks[1:]):
        rate = (h0 - h1) / h1 / (t1 - t0)
        number = abs(rate) * s.grainDiameter * sqrt(s.grainDensity / stress) if stress > 0 else 0
        assert found == pytest.approx(number, rel=1e-6)
