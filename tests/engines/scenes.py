"""Scenes that the tests of the engines share."""

from pathlib import Path

import grus  # first, since it loads YADE
from yade import O
from yade.wrapper import CrushingPlatens

from grus.card import Card
from grus.crushing import CrushingTest

MODELS = Path(__file__).parents[2] / "models"


def card(**overrides: object) -> Card:
    """The shipped card in YADE's own loop, with keys changed; `__` in a name stands for the dot."""
    changes = {name.replace("__", "."): value for name, value in overrides.items()}
    return Card.from_file(MODELS / "montesinho.toml").with_overrides(
        {
            "crush.speed": "0.05 m/s",
            "crush.loop": "InteractionLoop",
            "agglomerate.leftover": "single",
        }
        | changes
    )


def running(steps: int, **overrides: object) -> CrushingTest:
    """A crushing test after some steps."""
    test = CrushingTest(card(**overrides))
    O.run(steps, True)
    return test


def engine(kind: type) -> object:
    """The engine of that class in the current scene."""
    return next(e for e in O.engines if type(e).__name__ == kind.__name__)


def state() -> dict[str, list]:
    """Everything of the current scene that a later step depends on or a result is made of, exactly."""
    platens = engine(CrushingPlatens)
    bonds = sorted((*sorted((i.id1, i.id2)), i) for i in O.interactions)
    return {
        "iter": [O.iter],
        "dt": [O.dt],
        "position": [tuple(b.state.pos) for b in O.bodies],
        "orientation": [tuple(b.state.ori) for b in O.bodies],
        "velocity": [tuple(b.state.vel) + tuple(b.state.angVel) for b in O.bodies],
        "bonds": [(a, b, phys(i.phys)) for a, b, i in bonds],
        "record": [getattr(platens, name) for name in dir(platens) if name.startswith("record")],
        "work": [platens.work, platens.maxForce, platens.peakForce],
    }


def phys(p: object) -> tuple:
    """All attributes of an interaction's physics."""
    return tuple(tuple(v) if hasattr(v, "__len__") else v for v in p.dict().values())
