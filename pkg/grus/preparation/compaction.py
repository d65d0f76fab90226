"""Compaction: unbreakable grains are pressed together until they rest at the void ratio that is asked for."""

from dataclasses import replace
from math import atan

import numpy as np
from yade import O
from yade.wrapper import BondMat

from grus.card import Card
from grus.preparation.exo import solid_fraction
from grus.preparation.press import QUIET, Press, element_stiffness
from grus.preparation.rigid import fit_rigid
from grus.preparation.stream import Step, stream
from grus.preparation.walls import wall_box
from grus.scene import grain_material
from grus.specimen import Specimen

SKIN = 1.0
"""Of GrainLoop, over the radius of an element: grains move fast here, and elements of one grain are no pairs."""
EAGER = 1.0
"""Share of the stress error that the servo removes in a step."""
ROUGH = 0.02
"""Unbalanced force at which grains count as resting here; the seating goes on from there."""
OPENING = 2
"""Way by which opposite walls move apart to let go of the overlaps, over an overlap for each grain across."""
RELEASE = 400
"""Time steps in which they open."""
BEAT, TAPS = 1000, 60
"""Time steps from one tap to the next, and how many taps there are at most."""
SOFTEST_TAP, HARDEST_TAP = 0.7, 5.0
"""Largest speed that the first and the last tap give a grain, over root(stress / density)."""
MEETING = 2000
"""Time steps for the platens to meet resistance after they have closed to the box asked for."""
CYCLES = 12
"""Rounds of densifying and settling at most."""
ENOUGH = 0.6
"""Share of the tolerance within which the void ratio is met; the rest is room for the seating."""


class Compaction:
    """Grains that cannot break or bend, each one rigid clump, with soft contacts at first.

    parts: the grains, joined, each at the place of its exo-sphere; size: of the box [m]; attempt: number of the
    packing, for its taps.
    """

    def __init__(self, card: Card, parts: Specimen, size: np.ndarray, attempt: int = 0) -> None:
        self.card, self.grains = card, parts
        self.final = element_stiffness(grain_material(card), card.element.radius)
        self.soft = min(self.final, soft_stiffness(card, parts))
        self.taps = stream(card.seed, Step.TAPS, attempt)
        material = BondMat(
            label="grain",
            density=card.element.density,
            kn=self.soft,
            ks=self.soft,
            thickness=card.thickness or 0,
            frictionAngle=atan(card.contact.friction_coefficient),
        )
        corners = np.array([np.zeros(len(size)), size])
        rigid = replace(parts, clump=parts.grain)
        self.press = Press(
            card,
            rigid,
            corners,
            material,
            card.preparation.compaction_speed,
            SKIN * card.element.radius,
        )

    def run(self) -> tuple[float, float]:
        """Compacts; returns the void ratios at which the grains first came to rest, and at last.

        The platens close on grains with the card's friction. While they rest at a larger void ratio than asked for,
        friction is taken from them (down to `preparation.friction`), and if that is not enough they are tapped, until
        the void ratio is met. Then friction is given back, and contacts get their final stiffness. The small way that
        the platens still go until all rest is measured, and allowed for in the next cycle if it was too short.
        """
        press, target = self.press, self.card.specimen.void_ratio
        enough = target + ENOUGH * self.card.preparation.void_ratio_tolerance
        press.servo.relaxation = EAGER
        press.expect(ROUGH, QUIET // 5)
        stop, first = target + self.card.preparation.void_ratio_tolerance, None
        press.run(self._closing_steps(), stop)
        for _ in range(CYCLES):
            dense = press.void_ratio <= max(stop, enough) or self._densify(stop)
            before = press.void_ratio
            after = self._settle()
            first = after if first is None else first
            if after <= enough or not dense:
                break
            stop = min(target + max(before - after, 0), after)
            press.set_stiffness(self.soft)
            press.expect(ROUGH, QUIET // 5)
        return first, after

    def result(self) -> tuple[Specimen, np.ndarray]:
        """The grains as they were made, clumps and all, where they lie now; corners (2, dimension) of the box [m]."""
        placed = fit_rigid(self.grains, self.press.positions())
        return replace(self.grains, position=placed), np.array(wall_box(self.press.walls))

    def _closing_steps(self) -> int:
        """Time steps in which the platens close to the box asked for, twice over, and some to meet resistance."""
        lower, upper = wall_box(self.press.walls)
        height = float(upper[-1] - lower[-1])
        ratio = (1 + self.card.specimen.void_ratio) / (1 + self.press.void_ratio)
        way = max(height * (1 - ratio), 0)
        return MEETING + int(way / (self.card.preparation.compaction_speed * O.dt))

    def _densify(self, stop: float) -> bool:
        """Takes friction from the grains and taps them harder and harder; whether the void ratio falls to `stop`."""
        p = self.card.preparation
        self.press.set_friction(p.friction)
        sound = (p.seating_stress / self.card.element.density) ** 0.5
        rising = np.geomspace(SOFTEST_TAP, HARDEST_TAP, TAPS).round(6)  # the same everywhere
        for speed in sound * np.append(0.0, rising):
            self._tap(speed)
            if self.press.run(BEAT, stop):
                return True
        return False

    def _tap(self, speed: float) -> None:
        """Gives every grain a velocity at random, up to `speed` [m/s] along each axis."""
        dimension = self.card.dimension
        for grain in self.press.movable():
            kick = np.zeros(3)
            kick[:dimension] = speed * (2 * self.taps.random(dimension) - 1)
            grain.state.vel = tuple(kick.tolist())

    def _settle(self) -> float:
        """Gives friction back and lets all come to rest, with soft and then with hard contacts; the void ratio then.

        In between the box opens until overlaps are gone: hardening contacts as they are would lock stress between the
        sides. The sides then stay a little wider.
        """
        press, p = self.press, self.card.preparation
        press.set_friction(self.card.contact.friction_coefficient)
        press.to_rest()
        overlap = OPENING * p.compaction_overlap * self.card.element.radius
        lower, upper = wall_box(press.walls)
        across = (upper - lower) / self.grains.grain_diameter.mean()
        press.open((across * overlap).tolist(), RELEASE)
        press.set_stiffness(self.final)
        press.expect(ROUGH, QUIET)
        press.to_rest()
        return press.void_ratio


def soft_stiffness(card: Card, grains: Specimen) -> float:
    """Element stiffness [N/m] with which grains overlap by `preparation.compaction_overlap` under the seating stress.

    The mean contact force is taken as the stress times the square of the mean diameter, in the plane times diameter
    and thickness; a contact is two elements in series.
    """
    p = card.preparation
    diameter = float(grains.grain_diameter.mean())
    area = diameter * (card.thickness if card.dimension == 2 else diameter)
    return 2 * p.seating_stress * area / (p.compaction_overlap * card.element.radius)


def start_box(card: Card, exo_radius: np.ndarray, base: np.ndarray) -> np.ndarray:
    """Size (dimension,) [m] of the box in which exo-spheres fill the share that the card says."""
    unit = np.pi if card.dimension == 2 else 4 / 3 * np.pi
    volume = (
        unit * float(np.prod([exo_radius] * card.dimension, axis=0).sum()) / solid_fraction(card)
    )
    return np.append(base, volume / base.prod())
